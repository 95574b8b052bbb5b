// Runs jausdump, and makes what it reads.
#pragma once
#include "support/hex.hpp"
#include "support/paths.hpp"
#include "support/pcap.hpp"
#include "support/scratch.hpp"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/wait.h>

namespace dump_test {

using json = nlohmann::ordered_json;
using jauscat::test::content;
using jauscat::test::from_hex;
using jauscat::test::scratch;

struct outcome {
    int code{};
    std::string out{}, err{};

    [[nodiscard]] std::vector<std::string> lines() const {
        std::vector<std::string> all;
        std::istringstream text{out};
        for (std::string line; std::getline(text, line);) all.push_back(line);
        return all;
    }
    [[nodiscard]] std::vector<json> objects() const {
        std::vector<json> all;
        for (const auto& line : lines()) all.push_back(json::parse(line));
        return all;
    }
    [[nodiscard]] bool says(const std::string& text) const { return out.find(text) != std::string::npos; }
};

inline std::string jausdump() { return support::program("jausdump"); }

/// `before` goes in front of the command: variables.
inline outcome run(const std::string& arguments, const std::string& input = {}, const std::string& before = {}) {
    const scratch files;
    std::ofstream{files / "in"} << input;
    const auto command = before + " timeout 60 '" + jausdump() + "' " + arguments + " <" + (files / "in") + " >" +
                         (files / "out") + " 2>" + (files / "err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(files / "out"), content(files / "err")};
}

/// What `run` prints for one line of hex, as JSON.
inline json object_of(const std::string& hex, const std::string& arguments = {}) {
    const auto objects = run("--format json " + arguments, hex + "\n").objects();
    if (objects.size() != 1) throw std::runtime_error{"not one object"};
    return objects[0];
}

/// A capture file of frames given in hex, a second apart. `cut` bytes are left off its end.
inline void write_capture(const std::string& path, std::uint32_t link_type, const std::vector<std::string>& frames,
                          std::size_t cut = 0) {
    std::vector<std::byte> bytes;
    const auto append = [&](const auto& header) {
        const std::size_t at = bytes.size();
        bytes.resize(at + jauscat::wire::encoded_size(header));
        if (!jauscat::wire::encode(header, std::span{bytes}.subspan(at))) throw std::runtime_error{"header"};
    };
    append(jauscat::test::pcap_file_header{
        .magic = 0xA1B2C3D4, .major = 2, .minor = 4, .longest = 65535, .link_type = link_type});
    for (std::uint32_t second = 0; const auto& hex : frames) {
        const auto frame = from_hex(hex);
        const auto size = static_cast<std::uint32_t>(frame.size());
        append(jauscat::test::pcap_record_header{
            .seconds = 1000000000 + second++, .microseconds = 250, .captured = size, .original = size});
        bytes.insert(bytes.end(), frame.begin(), frame.end());
    }
    std::ofstream{path, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                static_cast<std::streamsize>(bytes.size() - cut));
}

/// `0a0b`: a number as two bytes, the larger first.
inline std::string two_bytes(std::size_t number) {
    return jauscat::test::to_hex(std::array{static_cast<std::byte>(number >> 8), static_cast<std::byte>(number)});
}
/// An IPv4 packet with a UDP datagram from 10.0.0.1:3794 to 10.0.0.2:3794.
inline std::string udp_packet(const std::string& payload, const std::string& fragment = "0000") {
    const std::size_t size = from_hex(payload).size();
    return "45 00 " + two_bytes(28 + size) + " 0001" + fragment + "40 11 0000 0a000001 0a000002 0ed2 0ed2 " +
           two_bytes(8 + size) + " 0000 " + payload;
}
inline std::string ethernet_frame(const std::string& packet) { return "020000000002 020000000001 0800 " + packet; }

inline constexpr std::uint32_t link_null = 0, link_ethernet = 1, link_raw = 101, link_cooked = 113, link_cooked_2 = 276,
                               link_user0 = 147, link_rtac_serial = 250;

// Messages in hex. Report Component Status from 1.1.33.1; Set Wrench Effort, 50 % along x and 12.5 % resistance along
// x, from 1.1.32.1 to 2.2.33.1, sequence 34; RequestControl of SAE JAUS in a datagram.
inline const std::string status = "0602 0240 01200101 01210101 0500 0700 0100000000";
inline const std::string wrench = "0602 0504 01210202 01200101 0500 2200 4100 ff3f 20";
inline const std::string control = "02 00 1100 01 06050400 03020100 0d0023 0700";

} // namespace dump_test
