// Raw Ethernet between two network namespaces, and what tshark makes of the frames.
#include "nodes/namespaces.hpp"
#include "nodes/robot.hpp"

#include <regex>

using namespace nodes;

namespace {

std::string tshark(const words& arguments) {
    program one{words{"tshark"} + arguments};
    one.wait();
    return one.output();
}
// A file that tshark is writing ends anywhere, which it says in a line of its own.
std::string frames(const std::string& file, const std::string& filter, const words& more = {}) {
    std::string found;
    std::istringstream lines{tshark(words{"-r", file, "-Y", filter} + more)};
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("tshark:") && !line.starts_with("Running as user")) found += line + "\n";
    return found;
}

// A capture from before the robot starts.
class capture {
  public:
    capture(robot& r, const words& in, const std::string& interface, const std::string& filter)
        : file_{r.folder / "wire.pcap"},
          tshark_{r.start_command(in + words{"tshark", "-q", "-i", interface, "-f", filter, "-w", file_})} {
        tshark_.wait_for_output("Capturing on");
    }
    [[nodiscard]] const std::string& file() const { return file_; }
    // Until it has the first frames: tshark says that it captures shortly before it does.
    void has_begun() {
        REQUIRE(eventually([&] {
            std::error_code none;
            return std::filesystem::file_size(file_, none) > 2000 && !none;
        }));
    }
    void stop() { tshark_.end(SIGINT); }

    // The SDO download of a full Set Wrench Effort.
    void has_download() {
        // Message properties 16 02 (acknowledgement wanted), source 1.1.32.1, any sequence number, then the body.
        const std::regex download{"0x1b15 0x1a 0x0000001c "
                                  "160201200101[0-9a-f]{4}ff0f00400040004001c001c001c0808080ffffff",
                                  std::regex::icase};
        const words fields{"-T", "fields",
                           "-E", "separator= ",
                           "-e", "ecat_mailbox.coe.sdoidx",
                           "-e", "ecat_mailbox.coe.sdosub",
                           "-e", "ecat_mailbox.coe.sdolength",
                           "-e", "ecat_mailbox.coe.dsoldata"};
        REQUIRE(eventually([&] {
            const auto found = frames(file_, "ecat_mailbox.coe.sdoreq == 1 && ecat.cnt == 1", fields);
            return std::regex_search(found, download);
        }));
    }
    void is_well_formed() {
        CHECK(frames(file_, "_ws.malformed || ecat_mailbox.invalid || ecat_mailbox.coe.invalid || "
                            "_ws.expert.severity == error") == "");
        CHECK(frames(file_, "!ecat") == "");
    }

  private:
    std::string file_;
    program& tshark_;
};

bool has_tshark() {
    if (is_installed("tshark")) return true;
    skip("tshark is missing");
    return false;
}

} // namespace

TEST_CASE("commands pass by raw Ethernet") {
    two_namespaces wire;
    if (!wire.exist()) return;
    robot r;
    wire.start_robot(r);
    r.command_arrives();
    CHECK(r.controller().has("link_opened", {{"link", "raw Ethernet on if_m"}}));
}

TEST_CASE("packets of a card's API are executed on a wire") {
    two_namespaces wire;
    if (!wire.exist()) return;
    robot r;
    const words card_packets = wire.in_master() + wrapper() + words{(bin() / "card_packets").string(), "if_m"};
    const auto lists = [&](const words& lines) {
        auto& one = r.start_command(card_packets);
        REQUIRE(one.wait() == 0);
        for (const auto& line : lines) {
            INFO(line);
            CHECK(one.has_output(line));
        }
    };
    r.prefix = wire.in_slave();
    SECTION("by the robot arm") {
        r.link = {"--link", "raw", "--interface", "if_s"};
        r.start_arm();
        lists({"slaves: 1", "0x1B15 \"component 33\", highest subindex 125", "state 4"});
    }
    SECTION("by emulated slaves") {
        auto& bus = r.start_bus(
            {"--link", "raw", "--interface", "if_s", "--slaves", "3", "--outputs", "4", "--mailbox-size", "24"});
        lists({"slaves: 3", "0x1018 \"Identity\", highest subindex 4",
               "0x2003 \"value of 28 bytes\", highest subindex 0", "0x7000 \"record\", highest subindex 4"});
        bus.wait_for("slave_state", {{"slave", 0}, {"state", "safe_op"}});
    }
}

TEST_CASE("tshark reads EtherCAT in UDP") {
    if (!has_tshark()) return;
    two_namespaces wire;
    if (!wire.exist()) return;
    robot r;
    r.prefix = wire.in_master();
    r.link = {}; // the registered port, which tshark knows
    capture all{r, r.prefix, "lo", "udp port 34980"};
    r.start();
    all.has_begun();
    r.command_arrives();
    all.has_download();
    all.stop();
    all.is_well_formed();
}

TEST_CASE("tshark reads raw frames") {
    if (!has_tshark()) return;
    two_namespaces wire;
    if (!wire.exist()) return;
    robot r;
    capture all{r, wire.in_master(), "if_m", "ether proto 0x88a4"};
    wire.start_robot(r);
    all.has_begun();
    r.command_arrives();
    all.has_download();
    all.stop();
    all.is_well_formed();
    CHECK(frames(all.file(), "frame.len < 60") == "");
}

TEST_CASE("tshark reads process data") {
    if (!has_tshark()) return;
    two_namespaces wire;
    if (!wire.exist()) return;
    robot r;
    r.master_options = r.master_options + robot::cyclic();
    capture all{r, wire.in_master(), "if_m", "ether proto 0x88a4"};
    wire.start_robot(r);
    all.has_begun();
    r.command_arrives();
    // LRW: outputs with the command that the controller has shown, then inputs with what the arm has in force.
    // Commands of no effort come before: one for each time that the slave is back.
    const std::string data = "0[2-9]00ff0f00400040004001c001c001c0808080ffffff";
    REQUIRE(eventually([&] {
        const auto found = frames(all.file(), "ecat.cmd == 12 && ecat.cnt == 3", {"-T", "fields", "-e", "ecat.data"});
        return std::regex_search(found, std::regex{"(^|\n)" + data + data + "[,\n]"});
    }));
    all.stop();
    all.is_well_formed();
}
