#include "support/known_messages.hpp"

#include "support/hex_line.hpp"
#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <cctype>

#ifdef JAUSCAT_PRIVATE_MESSAGES
#    include JAUSCAT_PRIVATE_MESSAGES
#else
using private_messages = jauscat::jaus::message_list<>;
#endif

namespace example {

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;

constexpr std::string_view as_hex = "hex=";

text::error error(std::string_view value, std::string message) {
    return {.code = text::errc::invalid_value, .value = std::string{value}, .message = std::move(message)};
}

jauscat::result<written_message, text::error> with_bytes(std::uint16_t code, std::string_view digits) {
    auto read = read_hex_line(digits);
    if (!read.error.empty()) return error(digits, "hex=" + std::string{digits} + ": " + read.what);
    return written_message{code, std::move(read.bytes)};
}

} // namespace

const catalogue::list& known_messages() {
    static const catalogue::list all{catalogue::ra_3_3(), catalogue::of<private_messages>()};
    return all;
}

std::string message_name(std::uint16_t command_code) {
    const auto* const known = known_messages().find(command_code);
    if (known == nullptr || jaus::is_standard(command_code)) return text::message_name(command_code);
    std::string name{known->name()};
    bool begins = true;
    for (char& c : name) {
        if (c == '_') c = ' ';
        if (begins) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        begins = c == ' ';
    }
    return name;
}

std::string summary(const jaus::header& head) { return text::summary(head, message_name(head.command_code)); }

std::string body_lines(std::uint16_t command_code, std::span<const std::byte> body, std::size_t first_offset) {
    const auto* const known = known_messages().find(command_code);
    return known != nullptr ? known->annotate(body, first_offset) : text::hex_dump(body, "  ", first_offset);
}

jauscat::result<written_message, text::error> read_message(std::string_view name, std::span<const std::string> words) {
    const bool is_hex = words.size() == 1 && words.front().starts_with(as_hex);
    const auto digits = is_hex ? std::string_view{words.front()}.substr(as_hex.size()) : std::string_view{};
    const auto type = known_messages().find(name);
    if (!type) {
        const auto code = text::command_code_from(name);
        if (!code) return type.error();
        if (is_hex) return with_bytes(*code, digits);
        return error(name, type.error().message + " that is known here: give its body in hex, such as " +
                               std::string{name} + " hex=0a14");
    }
    if (is_hex) return with_bytes((*type)->command_code(), digits);
    const auto message = (*type)->from_words(words);
    if (!message) return message.error();
    auto body = message->encode();
    if (!body) return error(name, std::string{jauscat::wire::describe(body.error())});
    return written_message{(*type)->command_code(), *std::move(body)};
}

} // namespace example
