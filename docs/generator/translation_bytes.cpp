// Writes the worked bytes into docs/translation.md: Set Wrench Effort with all fields as a JAUS message, as a packet,
// in the mailbox and in the frame, each made by the library and taken apart by its schemas.
#include <jauscat/ethercat/delivery.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/loopback_link.hpp>
#include <jauscat/ethercat/master.hpp>
#include <jauscat/jaus/message.hpp>
#include <jauscat/net/run_master.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/text/jaus.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using bytes = std::vector<std::byte>;

constexpr std::string_view begin_mark = "<!-- made by scripts/translation-bytes: begin -->\n";
constexpr std::string_view end_mark = "<!-- made by scripts/translation-bytes: end -->\n";
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
    const auto size =
        jaus::make_message({.priority = 6,
                            .destination = {.instance = 5, .component = 33, .node = station, .subsystem = 1},
                            .source = {.instance = 2, .component = 32, .node = 3, .subsystem = 4},
                            .sequence_number = 34},
                           efforts, message);
    if (!size || size.size() != message.size()) throw std::logic_error{"the message does not encode"};
    return message;
}

/// A slave with one object that takes anything.
struct any_object {
    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return ethercat::abort_code::none;
    }
};

/// Keeps what the master sends.
struct recording_link {
    ethercat::loopback_link& link;
    std::vector<bytes> sent{};

    bool send(std::span<const std::byte> frame) {
        sent.emplace_back(frame.begin(), frame.end());
        return link.send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) {
        return link.receive(buffer, timeout);
    }
};

/// The first frame of an SDO download, as the master sends it.
bytes frame_with(const ethercat::object_access& object) {
    any_object objects;
    std::array slaves{ethercat::slave{{.vendor = 1, .product = 2}, objects}};
    ethercat::loopback_link loop{slaves};
    recording_link link{loop};
    ethercat::master master;
    master.bring_up(0, station);
    if (!jauscat::net::run(link, master)) throw std::logic_error{"no slave"};
    link.sent.clear();
    master.download(station, object.index, object.subindex, object.data);
    if (!jauscat::net::run(link, master)) throw std::logic_error{"the slave does not take the object"};
    for (const auto& frame : link.sent)
        if (std::search(frame.begin(), frame.end(), object.data.begin(), object.data.end()) != frame.end())
            return frame;
    throw std::logic_error{"no frame carries the object whole"};
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
    using delivery = ethercat::delivery<Table>;
    bytes packet(delivery::translator::max_packet_size);
    const auto size = delivery::translator::forth(message, packet);
    if (!size) throw std::logic_error{"the message does not translate"};
    packet.resize(size.size());
    const auto object = delivery::object_of(packet);
    std::string out = block("The packet, " + table, packet,
                            dissection{packet}
                                .parts<jauscat::hilscher::sdo_download_request>()
                                .rest(object.data.size(), "abSdoData, n = " + std::to_string(object.data.size()))
                                .text());

    const auto frame = frame_with(object);
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

int run(const std::string& file, bool check) {
    const std::string before = contents_of(file);
    const auto begin = before.find(begin_mark), end = before.find(end_mark);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        throw std::runtime_error{file + " has no place for the bytes: \"" + std::string{begin_mark} + "\""};
    const std::string after =
        before.substr(0, begin) + std::string{begin_mark} + "\n" + worked_bytes() + before.substr(end);
    if (after == before) return 0;
    std::cout << file << (check ? " is not current: run scripts/translation-bytes\n" : " is written\n");
    if (check) return 1;
    std::ofstream{file} << after;
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments{argv + 1, argv + argc};
    if (arguments.empty() || arguments.size() > 2 || (arguments.size() == 2 && arguments[1] != "--check")) {
        std::cerr << "usage: translation_bytes FILE [--check]\n";
        return 2;
    }
    try {
        return run(arguments[0], arguments.size() == 2);
    } catch (const std::exception& e) {
        std::cerr << "translation_bytes: " << e.what() << "\n";
        return 1;
    }
}
