// Writes the worked bytes into docs/translation.md: Set Wrench Effort with all fields as a JAUS message, as a packet,
// in the mailbox and in the frame, each made by the library and taken apart by its schemas. And docs/data-path.svg.
#include "data_path.hpp"
#include "sdo_frame.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/text/jaus.hpp>

#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using jauscat::reference::bytes;

constexpr std::string_view begin_mark = "<!-- made by scripts/message-reference: begin -->\n";
constexpr std::string_view end_mark = "<!-- made by scripts/message-reference: end -->\n";
constexpr std::uint16_t station = 2;

bytes full_wrench_effort() {
    const jaus::set_wrench_effort efforts{.propulsive_linear_effort_x = 100,
                                          .propulsive_linear_effort_y = -100,
                                          .propulsive_linear_effort_z = 0,
                                          .propulsive_rotational_effort_x = 50,
                                          .propulsive_rotational_effort_y = -50,
                                          .propulsive_rotational_effort_z = 25,
                                          .resistive_linear_effort_x = 0,
                                          .resistive_linear_effort_y = 100,
                                          .resistive_linear_effort_z = 50,
                                          .resistive_rotational_effort_x = 20,
                                          .resistive_rotational_effort_y = 40,
                                          .resistive_rotational_effort_z = 60};
    bytes message(jaus::header_size + wire::max_size<jaus::set_wrench_effort>);
    const auto message_bytes =
        jaus::make_message({.priority = 6,
                            .destination = {.instance = 5, .component = 33, .node = station, .subsystem = 1},
                            .source = {.instance = 2, .component = 32, .node = 3, .subsystem = 4},
                            .sequence_number = 34},
                           efforts, message);
    if (!message_bytes || message_bytes->size() != message.size())
        throw std::logic_error{"the message does not encode"};
    return message;
}

/// Takes messages apart one behind the other.
class dissection {
  public:
    explicit dissection(std::span<const std::byte> all) : all_{all} {}

    template <class... Parts> dissection& parts() {
        (part<Parts>(), ...);
        return *this;
    }
    dissection& rest(std::size_t size, const std::string& what) {
        out_ += "  " + what + ", from byte " + std::to_string(at_) + ":\n";
        out_ += text::hex_dump(all_.subspan(at_, size), "    ");
        at_ += size;
        return *this;
    }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] const std::string& text() const { return out_; }

  private:
    template <class Part> void part() {
        out_ += "  " + std::string{wire::type_name<Part>()} + "\n";
        out_ += text::annotate<Part>(all_.subspan(at_, wire::max_size<Part>), at_, "    ");
        at_ += wire::max_size<Part>;
    }

    std::span<const std::byte> all_;
    std::size_t at_{};
    std::string out_{};
};

std::string block(const std::string& title, std::span<const std::byte> whole, const std::string& apart) {
    return "### " + title + "\n\n" + std::to_string(whole.size()) + " bytes:\n\n```text\n" + text::hex_dump(whole, "") +
           "```\n\n```text\n" + apart + "```\n\n";
}

template <class Table> std::string stages(const std::string& table, const bytes& message) {
    using stage = bridging::delivery<Table>;
    bytes packet(stage::translator::max_packet_size);
    const auto translated = stage::translator::to_packet(message, packet);
    if (!translated) throw std::logic_error{"the message does not translate"};
    packet.resize(translated->size());
    const auto object = stage::object_of(packet);
    std::string out = block("The packet, " + table, packet,
                            dissection{packet}
                                .parts<jauscat::hilscher::sdo_download_request>()
                                .rest(object.data.size(), "abSdoData, n = " + std::to_string(object.data.size()))
                                .text());

    const auto frame = jauscat::reference::frame_with(object);
    dissection apart{frame};
    apart.parts<ethercat::ethernet_header, ethercat::frame_header, ethercat::datagram_header>();
    const std::size_t mailbox_at = apart.at();
    ethercat::datagram_header datagram{};
    static_cast<void>(wire::decode_prefix(
        datagram, std::span{frame}.subspan(mailbox_at - wire::max_size<ethercat::datagram_header>)));
    const auto mailbox = std::span{frame}.subspan(mailbox_at, datagram.length);

    dissection inside{mailbox};
    inside.parts<ethercat::mailbox_header, ethercat::coe_header, ethercat::sdo_normal>();
    inside.rest(object.data.size(), "the object's data");
    const std::size_t unused = mailbox.size() - inside.at();
    const auto used = mailbox.first(inside.at());
    out += block("The mailbox, " + table, used, inside.text());
    out += "The mailbox of this slave has " + std::to_string(mailbox.size()) + " bytes; the other " +
           std::to_string(unused) + " are zeros.\n\n";

    apart.rest(datagram.length, "the mailbox");
    apart.parts<ethercat::datagram_trailer>();
    out += "### The frame, " + table + "\n\n" + std::to_string(frame.size()) +
           " bytes without check sequence:\n\n```text\n" + apart.text() + "```\n\n";
    return out;
}

std::string worked_bytes() {
    const bytes message = full_wrench_effort();
    return block("The JAUS message", message,
                 text::annotate_message(message, jaus::message_list<jaus::set_wrench_effort>{})) +
           stages<jauscat::translation::seed_table>("seed table", message) +
           stages<jauscat::translation::self_contained_table>("self-contained table", message);
}

std::string contents_of(const std::string& file) {
    std::ifstream in{file};
    if (!in) throw std::runtime_error{"cannot read " + file};
    return (std::ostringstream{} << in.rdbuf()).str();
}

/// Returns whether the file was as it should be, or is now.
bool put(const std::string& file, const std::string& before, const std::string& after, bool check) {
    if (after == before) return true;
    std::cout << file << (check ? " is not current: run scripts/message-reference\n" : " is written\n");
    if (!check) std::ofstream{file} << after;
    return !check;
}

bool put_bytes(const std::string& file, bool check) {
    const std::string before = contents_of(file);
    const auto begin = before.find(begin_mark), end = before.find(end_mark);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        throw std::runtime_error{file + " has no place for the bytes: \"" + std::string{begin_mark} + "\""};
    return put(file, before,
               before.substr(0, begin) + std::string{begin_mark} + "\n" + worked_bytes() + before.substr(end), check);
}

bool put_picture(const std::string& file, bool check) {
    return put(file, std::ifstream{file} ? contents_of(file) : "", jauscat::reference::data_path_picture(), check);
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments{argv + 1, argv + argc};
    if (arguments.size() < 2 || arguments.size() > 3 || (arguments.size() == 3 && arguments[2] != "--check")) {
        std::cerr << "usage: translation_bytes DOCUMENT PICTURE [--check]\n";
        return 2;
    }
    try {
        const bool check = arguments.size() == 3, bytes_good = put_bytes(arguments[0], check),
                   picture_good = put_picture(arguments[1], check);
        return bytes_good && picture_good ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << "translation_bytes: " << e.what() << "\n";
        return 1;
    }
}
