#pragma once
#include <jauscat/catalogue/any_message.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/print.hpp>

namespace jauscat::catalogue {

JAUSCAT_FUNCTION any_message entry::make() const { return any_message{*this}; }

JAUSCAT_FUNCTION result<any_message, wire::diagnosis> entry::decode(std::span<const std::byte> body) const {
    std::vector<std::byte> bytes{body.begin(), body.end()};
    // Elements are larger than their bytes: doubles for scaled integers, and what is optional.
    const std::size_t memory = data_->has_lists ? 256 + 16 * body.size() : 0;
    auto made = any_message::made_by(
        *this, memory, [&](void* object, wire::arena& arena) { return data_->decode(object, bytes, arena); });
    if (made) {
        made->bytes_ = std::move(bytes); // the same memory
        return std::move(*made);
    }
    wire::diagnosis why = data_->diagnose(bytes);
    why.error = made.error(); // a diagnosis knows no lack of memory
    return why;
}

JAUSCAT_FUNCTION result<any_message, text::error> entry::from_words(std::span<const std::string> words) const {
    constexpr std::size_t memory = 1024;
    return any_message::made_by(*this, memory, [&](void* object, wire::arena& arena) {
        return text::from_words(words, data_->fields(), object, arena);
    });
}

JAUSCAT_FUNCTION result<any_message, text::error> entry::from_text(std::string_view line) const {
    const auto words = text::split(line);
    if (!words) return words.error();
    return from_words(*words);
}

JAUSCAT_FUNCTION std::string any_message::to_text(std::size_t indent) const {
    return text::to_text(data_->fields(), object_.get(), indent);
}

JAUSCAT_FUNCTION std::string entry::to_text(std::span<const std::byte> body, std::size_t indent) const {
    const auto message = decode(body);
    return message ? message->to_text(indent) : std::string(indent, ' ') + text::to_text(message.error()) + "\n";
}

} // namespace jauscat::catalogue
