// An outside judge: tshark reads what this master and this slave put on a wire, and has to see what was meant. On a
// pair of virtual Ethernet interfaces, jc0 and jc1: see support/in_veth.sh.
#include "ethercat/objects.hpp"
#include "support/bytes.hpp"
#include "support/capture.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/slave_thread.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/now.hpp>

#include <optional>
#include <sstream>
#include <string>

using namespace jauscat;
using namespace std::chrono_literals;
using ethercat::master_errc;
using test::counting;

namespace {

using rows = std::vector<std::string>;

constexpr std::uint16_t station = 2;

/// `size` bytes of the data from `from` on, as tshark prints them.
std::string part(const std::vector<std::byte>& data, std::size_t from, std::size_t size) {
    std::string text;
    for (std::size_t i = from; i != from + size; ++i) {
        std::array<char, 3> two{};
        std::snprintf(two.data(), two.size(), "%02x", std::to_integer<unsigned>(data[i]));
        text += two.data();
    }
    return text;
}

/// Frames that tshark cannot read to the end, reads as something else, or finds odd.
rows complaints(const test::capture& capture) {
    return capture.summary("_ws.malformed || _ws.expert.severity >= warning || ecat_mailbox.invalid || "
                           "ecat_mailbox.coe.invalid || !ecat || data || frame.len < 60 || frame.len > 1514 || "
                           "ecatf.type != 1 || ecatf.reserved != 0 || ecat.subframe.reserved != 0 || "
                           "ecat.subframe.circulating == 1 || eth.dst != ff:ff:ff:ff:ff:ff");
}

/// A master on jc0 and slaves on jc1, and the capture of all that passes between them.
struct master_and_slaves {
    explicit master_and_slaves(std::span<ethercat::slave> slaves) : slaves_thread{"jc1", slaves} {}

    test::capture capture{"jc0"};
    net::raw_link link{"jc0"};
    test::slave_thread slaves_thread;
    ethercat::master_for<16> master{{.frame_timeout = 2s}}; // on a busy machine, too, nothing is asked twice

    template <ethercat::master_job Job> auto run(const Job& job) {
        const auto result = net::run(link, master, job);
        INFO(describe(result.error()) << ' ' << describe_reason(result.error()));
        REQUIRE(result);
        if constexpr (!std::is_void_v<typename Job::result_type::value_type>) return *result;
    }
    ethercat::bring_up::result_type bring_up(std::uint16_t position = 0, std::uint16_t address = station) {
        return net::run(link, master, ethercat::bring_up{position, address});
    }

    /// Whatever was sent: nothing is missing in the capture, and tshark finds nothing to complain of.
    void judge() {
        capture.end();
        CHECK(capture.summary("").size() == 2 * slaves_thread.frames()); // out and back
        CHECK(complaints(capture) == rows{});
        CHECK(capture.summary("ecat_mailbox && (ecat_mailbox.address != 0 || ecat_mailbox.counter == 0 || "
                              "ecat_mailbox.coe.number != 0)") == rows{});
        // The length in the frame's header is that of the datagrams: header, data, working counter.
        for (const auto& row : capture.rows("ecat", {"ecatf.length", "ecat.subframe.length"})) {
            std::istringstream line{row};
            unsigned announced = 0, sum = 0, length = 0;
            line >> std::hex >> announced;
            for (std::string item; std::getline(line, item, ',');) {
                std::istringstream{item} >> length;
                sum += 12 + length;
            }
            CHECK(announced == sum);
        }
    }
};

/// One slave with objects of several sizes at 2000h, mailboxes of 128 bytes.
struct one_slave {
    test::objects objects{};
    std::array<std::byte, 1000> memory{};
    ethercat::slave_description description{.mailbox_out_size = 128, .mailbox_in_size = 128};
    std::array<ethercat::slave, 1> slaves{ethercat::slave{description, objects, {.transfer_memory = memory}}};
    master_and_slaves w{slaves};
};

/// An array of three numbers at 2001h that says what it is.
struct three_numbers {
    static constexpr std::uint16_t at = 0x2001;
    std::array<std::byte, 6> values{};

    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        if (index != at) return {.error = ethercat::abort_code::no_object};
        if (subindex > 3) return {.error = ethercat::abort_code::no_subindex};
        out.front() = std::byte{3};
        if (subindex != 0) std::ranges::copy(of(subindex), out.begin());
        return {.size = subindex == 0 ? std::size_t{1} : std::size_t{2}};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        if (index != at) return ethercat::abort_code::no_object;
        if (subindex == 0) return ethercat::abort_code::read_only;
        std::ranges::copy(data, of(subindex).begin());
        return ethercat::abort_code::none;
    }
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        return after < at ? at : std::uint16_t{};
    }
    [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept {
        if (index != at) return {};
        return ethercat::object_info{.data_type = ethercat::data_types::unsigned16,
                                     .highest_subindex = 3,
                                     .code = ethercat::object_code::array,
                                     .name = "Three numbers",
                                     .complete_access = true};
    }
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                               std::uint8_t subindex) const noexcept {
        if (index != at || subindex > 3) return {};
        if (subindex == 0) return ethercat::highest_subindex_info;
        return ethercat::entry_info{.data_type = ethercat::data_types::unsigned16,
                                    .bits = 16,
                                    .access = ethercat::accessible_always,
                                    .name = "Number"};
    }

  private:
    std::span<std::byte> of(std::uint8_t subindex) noexcept {
        return std::span{values}.subspan(2 * (subindex - std::size_t{1}), 2);
    }
};

} // namespace

TEST_CASE("the judge detects a fault") {
    test::capture capture{"jc0"};
    net::raw_link link{"jc0"};
    std::vector<std::byte> frame(60);
    const auto truncated =
        support::bytes(0x88, 0xA4, 0xFF, 0x17, 5, 1, 2, 0, 0, 0x10, 0xE8, 0x03); // 1000 bytes of data
    std::ranges::copy(truncated, frame.begin() + 12);
    REQUIRE(link.send(frame));
    frame[14] = frame[15] = std::byte{0x40}; // another type than datagrams
    REQUIRE(link.send(frame));
    capture.end();
    CHECK(capture.summary("").size() == 2);
    CHECK(complaints(capture).size() == 2);
}

TEST_CASE("tshark reads a bring-up") {
    one_slave s;
    auto& w = s.w;
    REQUIRE(w.bring_up().error().code == master_errc::ok);
    CHECK(w.master.statistics().sent <= 30);
    w.judge();
    const std::string taken = "ecat.sub1.cnt == 1 && ";
    CHECK(w.capture.rows(taken + "ecat.cmd == 2", {"ecat.ado", "ecat.reg.physaddr"}) == rows{"0x0010 0x0002"});
    CHECK(w.capture.rows(taken + "ecat.reg.alctrl", {"ecat.adp", "ecat.reg.alctrl.ctrl", "ecat.reg.alctrl.errack"}) ==
          rows{"0x0002 0x0001 1", "0x0002 0x0002 0"});
    CHECK(w.capture
              .rows(taken + "ecat.reg.alstatus",
                    {"ecat.reg.alstatus.status", "ecat.reg.alstatus.err", "ecat.reg.alstatuscode"})
              .back() == "0x0002 0 0x0000");
    // Identity and mailboxes from the SII, 4 bytes each.
    CHECK(w.capture.rows(taken + "ecat.cmd == 5 && ecat.reg.ctrlstat",
                         {"ecat.reg.ctrlstat", "ecat.reg.addrl", "ecat.reg.addrh"}) ==
          rows{"0x0100 0x0008 0x0000", "0x0100 0x000a 0x0000", "0x0100 0x000c 0x0000", "0x0100 0x000e 0x0000",
               "0x0100 0x0018 0x0000", "0x0100 0x001a 0x0000", "0x0100 0x001c 0x0000"});
    // No process data from an earlier master, then the mailboxes.
    CHECK(
        w.capture.rows(taken + "ecat.cmd == 5 && ecat.syncman", {"ecat.syncman.start", "ecat.syncman.len",
                                                                 "ecat.syncman.ctrlstatus", "ecat.syncman.smenable"}) ==
        rows{"0x0000,0x0000,0x1000,0x1600 0x0000,0x0000,0x0080,0x0080 0x0000,0x0000,0x0026,0x0022 "
             "0x0000,0x0000,0x0001,0x0001"});
}

TEST_CASE("tshark reads SDO transfers") {
    one_slave s;
    auto& w = s.w;
    REQUIRE(w.bring_up().error().code == master_errc::ok);
    const auto data = counting(300);
    std::uint8_t subindex = 0;
    for (const std::size_t size : {1u, 2u, 3u, 4u, 28u, 300u}) {
        s.objects.add(0x2000, ++subindex, size);
        w.run(ethercat::download{station, 0x2000, subindex, std::span{data}.first(size)});
        std::array<std::byte, 1000> read{};
        CHECK(w.run(ethercat::upload{station, 0x2000, subindex, read}).size() == size);
        CHECK(test::to_hex(std::span{read}.first(size)) == test::to_hex(std::span{data}.first(size)));
    }
    CHECK(net::run(w.link, w.master, ethercat::download{station, 0x3000, 7, std::span{data}.first(28)}).error() ==
          ethercat::master_error{.code = master_errc::sdo_abort, .abort = ethercat::abort_code{0x06020000}});
    w.judge();

    const std::string taken = "ecat_mailbox && ecat.sub1.cnt == 1";
    // Every request, once each: mailbox length, counter 1 to 7 without a gap.
    rows headers;
    unsigned counter = 0;
    const auto header = [&](unsigned length) {
        counter = counter % 7 + 1;
        headers.push_back(std::to_string(length) + " 3 " + std::to_string(counter) + " 2");
    };
    for (const unsigned length :
         {10u, 10u, 10u, 10u, 10u, 10u, 10u, 10u, 38u, 10u, 122u, 122u, 72u, 10u, 10u, 10u, 38u})
        header(length);
    CHECK(w.capture.rows(taken + " && ecat.cmd == 5", {"ecat_mailbox.length", "ecat_mailbox.type",
                                                       "ecat_mailbox.counter", "ecat_mailbox.coe.type"}) == headers);

    // Downloads: specifier, size indicated, expedited, unused bytes (two bits), complete access, object, size, data.
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdoreq == 1",
                         {"ecat_mailbox.coe.sdoccsid.sizeind", "ecat_mailbox.coe.sdoccsid.expedited",
                          "ecat_mailbox.coe.sdoccsid.size1", "ecat_mailbox.coe.sdoccsid.size0",
                          "ecat_mailbox.coe.sdoccsid.complete", "ecat_mailbox.coe.sdoidx", "ecat_mailbox.coe.sdosub",
                          "ecat_mailbox.coe.sdolength", "ecat_mailbox.coe.dsoldata", "ecat_mailbox.coe.sdodata"}) ==
          rows{"1 1 1 1 0 0x2000 0x01 - - 0x01", "1 1 1 0 0 0x2000 0x02 - - 0x0201",
               "1 1 0 1 0 0x2000 0x03 - - 0x00030201", "1 1 0 0 0 0x2000 0x04 - - 0x04030201",
               "1 0 0 0 0 0x2000 0x05 0x0000001c " + part(data, 0, 28) + " -",
               "1 0 0 0 0 0x2000 0x06 0x0000012c " + part(data, 0, 112) + " -",
               "1 0 0 0 0 0x3000 0x07 0x0000001c " + part(data, 0, 28) + " -"});
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdoreq == 0",
                         {"ecat_mailbox.coe.sdoccsds.toggle", "ecat_mailbox.coe.sdoccsds.lastseg",
                          "ecat_mailbox.coe.sdoccsds.size", "ecat_mailbox.coe.dsoldata"}) ==
          rows{"0 0 0 " + part(data, 112, 119), "1 1 0 " + part(data, 231, 69)});
    // Uploads, and their segments.
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdoreq == 2",
                         {"ecat_mailbox.coe.sdoidx", "ecat_mailbox.coe.sdosub"}) ==
          rows{"0x2000 0x01", "0x2000 0x02", "0x2000 0x03", "0x2000 0x04", "0x2000 0x05", "0x2000 0x06"});
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdoreq == 3", {"ecat_mailbox.coe.sdoccsus_toggle"}) ==
          rows{"0", "1"});

    // The slave's answers.
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdores == 3",
                         {"ecat_mailbox.length", "ecat_mailbox.coe.type", "ecat_mailbox.coe.sdoidx",
                          "ecat_mailbox.coe.sdosub"}) == rows{"10 3 0x2000 0x01", "10 3 0x2000 0x02",
                                                              "10 3 0x2000 0x03", "10 3 0x2000 0x04",
                                                              "10 3 0x2000 0x05", "10 3 0x2000 0x06"});
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdores == 2",
                         {"ecat_mailbox.coe.sdoscsiu_sizeind", "ecat_mailbox.coe.sdoscsiu_expedited",
                          "ecat_mailbox.coe.sdoscsiu_size1", "ecat_mailbox.coe.sdoscsiu_size0",
                          "ecat_mailbox.coe.sdolength", "ecat_mailbox.coe.dsoldata", "ecat_mailbox.coe.sdodata"}) ==
          rows{"1 1 1 1 - - 0x01", "1 1 1 0 - - 0x0201", "1 1 0 1 - - 0x00030201", "1 1 0 0 - - 0x04030201",
               "1 0 0 0 0x0000001c " + part(data, 0, 28) + " -", "1 0 0 0 0x0000012c " + part(data, 0, 112) + " -"});
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdores == 1", {"ecat_mailbox.coe.sdoscsds_toggle"}) ==
          rows{"0", "1"});
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.sdores == 0",
                         {"ecat_mailbox.coe.sdoscsus_toggle", "ecat_mailbox.coe.sdoscsus_lastseg",
                          "ecat_mailbox.coe.sdoscsus_bytes", "ecat_mailbox.coe.dsoldata"}) ==
          rows{"0 0 0 " + part(data, 112, 119), "1 1 0 " + part(data, 231, 69)});
    CHECK(w.capture.rows(taken + " && ecat_mailbox.coe.abortcode",
                         {"ecat_mailbox.coe.type", "ecat_mailbox.coe.abortcode"}) == rows{"2 0x06020000"});
}

TEST_CASE("tshark reads complete access and SDO information") {
    three_numbers numbers;
    // Large enough for every answer: tshark takes each fragment for the first one.
    ethercat::slave_description description{.mailbox_out_size = 48, .mailbox_in_size = 48};
    ethercat::standard_objects objects{description, numbers};
    std::array<std::byte, 64> memory{};
    std::array slaves{ethercat::slave{description, objects, {.transfer_memory = memory}}};
    master_and_slaves w{slaves};
    REQUIRE(w.bring_up().error().code == master_errc::ok);
    std::array<std::byte, 64> into{};
    const auto data = counting(6);
    w.run(ethercat::download{station, numbers.at, 1, data, {.complete_access = true}});
    CHECK(std::ranges::equal(numbers.values, data));
    CHECK(test::to_hex(w.run(ethercat::upload{station, numbers.at, 0, into, {.complete_access = true}})) ==
          "03 00 01 02 03 04 05 06");
    CHECK(test::to_hex(w.run(ethercat::list_objects{station, ethercat::object_list_type::all, into}).bytes()) ==
          "00 10 08 10 18 10 00 1c 01 20");
    w.run(ethercat::describe_object{station, numbers.at, into});
    w.run(ethercat::describe_entry{station, numbers.at, 2, 0, into});
    CHECK(net::run(w.link, w.master, ethercat::describe_object{station, 0x3000, into}).error().code ==
          master_errc::sdo_abort);
    w.judge();

    const std::string taken = "ecat_mailbox && ecat.sub1.cnt == 1 && ";
    CHECK(w.capture.rows(taken + "ecat_mailbox.coe.sdoreq == 1",
                         {"ecat_mailbox.coe.sdoccsid.complete", "ecat_mailbox.coe.sdoidx", "ecat_mailbox.coe.sdosub",
                          "ecat_mailbox.coe.sdolength", "ecat_mailbox.coe.dsoldata"}) ==
          rows{"1 0x2001 0x01 0x00000006 010203040506"});
    CHECK(w.capture.rows(taken + "ecat_mailbox.coe.sdores == 2",
                         {"ecat_mailbox.coe.sdoscsiu_complete", "ecat_mailbox.coe.sdolength",
                          "ecat_mailbox.coe.dsoldata"}) == rows{"1 0x00000008 0300010203040506"});
    // Questions: the list of all objects, an object, its entry, one that is not there.
    CHECK(w.capture.rows(taken + "ecat.cmd == 5 && ecat_mailbox.coe.type == 8",
                         {"ecat_mailbox.coe.sdoinfoopcode", "ecat_mailbox.coe.sdoinfofrag",
                          "ecat_mailbox.coe.sdoinfolisttype", "ecat_mailbox.coe.sdoinfoindex",
                          "ecat_mailbox.coe.sdoinfosubindex"}) ==
          rows{"1 0x0000 0x0001 - -", "3 0x0000 - 0x2001 -", "5 0x0000 - 0x2001 0x02", "3 0x0000 - 0x3000 -"});
    // Answers: UNSIGNED16, array up to subindex 3; 16 bits, to be read and written in every state; an abort code.
    CHECK(w.capture.rows(
              taken + "ecat.cmd == 4 && ecat_mailbox.coe.type == 8",
              {"ecat_mailbox.coe.sdoinfoopcode", "ecat_mailbox.coe.sdoinfofrag", "ecat_mailbox.coe.sdoinfoindex",
               "ecat_mailbox.coe.sdoinfosubindex", "ecat_mailbox.coe.sdoinfodatatype", "ecat_mailbox.coe.sdoinfobitlen",
               "ecat_mailbox.coe.sdoinfomaxsub", "ecat_mailbox.coe.sdoinfoobjcode", "ecat_mailbox.coe.sdoinfoobjaccess",
               "ecat_mailbox.coe.sdoinfoname", "ecat_mailbox.coe.sdoinfoerrorcode"}) ==
          rows{"2 0x0000 - - - - - - - - -", "4 0x0000 0x2001 - 0x0006 - 0x03 0x08 - Three numbers -",
               "6 0x0000 0x2001 0x02 0x0006 0x0010 - - 0x003f Number -", "7 0x0000 - - - - - - - - 0x06020000"});
}

TEST_CASE("tshark reads the state changes of two slaves to OP, and their cycles") {
    constexpr std::array outputs{ethercat::pdo_entry{0x7000, 1, 16, 6, "first"},
                                 ethercat::pdo_entry{0x7000, 2, 16, 6, "second"}};
    constexpr std::array inputs{ethercat::pdo_entry{0x6000, 1, 8, 5, "level"}};
    ethercat::slave_description description{.outputs = outputs, .inputs = inputs};
    test::objects none{};
    ethercat::standard_objects objects{description, none};
    std::array slaves{ethercat::slave{description, objects}, ethercat::slave{description, objects}};
    slaves[0].inputs()[0] = std::byte{0xA5};
    slaves[1].inputs()[0] = std::byte{0x5A};
    master_and_slaves w{slaves};
    CHECK(w.run(ethercat::scan{}) == 2);
    for (const std::uint16_t position : std::array<std::uint16_t, 2>{0, 1}) {
        const auto address = static_cast<std::uint16_t>(station + position);
        REQUIRE(w.bring_up(position, address).error().code == master_errc::ok);
        w.run(ethercat::configure{address});
        w.run(ethercat::change_state{address, ethercat::al_state::safe_op});
    }

    ethercat::process_data_for<4, 256> cyclic{w.master.slaves()};
    std::array<std::byte, ethercat::max_frame_size> frame{};
    const auto now = [] { return jauscat::net::now(); };
    // Gives what arrives to the one that waits for it.
    const auto exchange = [&](std::size_t size, auto on_frame) {
        if (size == 0) return;
        REQUIRE(w.link.send(std::span{frame}.first(size)));
        size = w.link.receive(frame, 1s);
        REQUIRE(on_frame(std::span{frame}.first(size)));
    };
    const auto cycle = [&] {
        cyclic.begin_cycle();
        exchange(cyclic.next_frame(frame, now()), [&](auto reply) { return cyclic.on_frame(reply); });
        CHECK(cyclic.working_counter() == 6);
        exchange(w.master.next_frame(frame, now()), [&](auto reply) { return w.master.on_frame(reply, now()); });
    };
    for (const std::uint16_t address : {station, static_cast<std::uint16_t>(station + 1)}) {
        REQUIRE(w.master.start(ethercat::change_state{address, ethercat::al_state::op}));
        while (!w.master.idle()) cycle();
        REQUIRE(w.master.error() == ethercat::master_error{});
    }
    const auto setting_up = w.slaves_thread.frames();
    const std::vector<std::byte> values = counting(8);
    std::ranges::copy(std::span{values}.first(4), cyclic.outputs(w.master.slaves()[0]).begin());
    std::ranges::copy(std::span{values}.last(4), cyclic.outputs(w.master.slaves()[1]).begin());
    for (int i = 0; i != 3; ++i) cycle();
    CHECK(cyclic.inputs(w.master.slaves()[0])[0] == std::byte{0xA5});
    CHECK(cyclic.inputs(w.master.slaves()[1])[0] == std::byte{0x5A});
    w.judge();

    // Each slave has its outputs and its inputs in a SyncManager, which is off while it changes, and in an FMMU, after
    // all eight are cleared.
    const std::string setting = "ecat.cmd == 5 && ecat.sub1.cnt == 1 && ecat.fmmu";
    const std::string managers = "0x1c00,0x1c00,0x2400,0x2400 0x0004,0x0004,0x0001,0x0001 "
                                 "0x0064,0x0064,0x0020,0x0020 0x0000,0x0001,0x0000,0x0001";
    CHECK(w.capture.rows(setting, {"ecat.syncman.start", "ecat.syncman.len", "ecat.syncman.ctrlstatus",
                                   "ecat.syncman.smenable"}) == rows{managers, managers});
    const auto after_clearing = [](const std::string& zero, const std::string& rest) {
        std::string text;
        for (int i = 0; i != 8; ++i) text += zero + ",";
        return text + rest;
    };
    const auto ending = " " + after_clearing("0x0000", "0x0004,0x0001") + " " + after_clearing("0x00", "0x07,0x07") +
                        " " + after_clearing("0x0000", "0x1c00,0x2400") + " " + after_clearing("0x00", "0x02,0x01") +
                        " " + after_clearing("0x00", "0x01,0x01");
    CHECK(w.capture.rows(setting, {"ecat.fmmu.lstart", "ecat.fmmu.llen", "ecat.fmmu.lendbit", "ecat.fmmu.pstart",
                                   "ecat.fmmu.type", "ecat.fmmu.activate"}) ==
          rows{after_clearing("0x00000000", "0x00000000,0x00000004") + ending,
               after_clearing("0x00000000", "0x00000005,0x00000009") + ending});
    // Outputs out, inputs back: logical address 0, working counter 2 for outputs and 1 for inputs of each slave.
    const std::string cycles = "ecat.cmd == 12 && frame.number > " + std::to_string(2 * setting_up);
    CHECK(w.capture.rows(cycles, {"ecat.lad", "ecat.cnt", "ecat.data"}) ==
          rows{"0x00000000 0 01020304a5050607085a", "0x00000000 6 01020304a5050607085a",
               "0x00000000 0 01020304a5050607085a", "0x00000000 6 01020304a5050607085a",
               "0x00000000 0 01020304a5050607085a", "0x00000000 6 01020304a5050607085a"});
    CHECK(w.capture.rows("ecat.reg.alctrl && ecat.cnt == 1 && ecat.cmd == 5", {"ecat.adp", "ecat.reg.alctrl.ctrl"}) ==
          rows{"0x0002 0x0001", "0x0002 0x0002", "0x0002 0x0004", "0x0003 0x0001", "0x0003 0x0002", "0x0003 0x0004",
               "0x0002 0x0008", "0x0003 0x0008"});
}
