// Slaves made of ESI files as vendors write them: a master brings each to OP, and finds what the file says.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/esi/device_sii.hpp>
#include <jauscat/esi/emulated_objects.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

using namespace jauscat;
using namespace jauscat::ethercat;
using bytes = std::vector<std::byte>;

namespace {

/// A file with one device of this content.
std::string file_of(const std::string& device, const std::string& attributes = R"(Physics="YY")") {
    return "<EtherCATInfo><Vendor><Id>#x0000AB12</Id><Name>Vendor</Name></Vendor><Descriptions><Groups><Group>"
           "<Type>things</Type><Name>Things</Name></Group></Groups><Devices><Device " +
           attributes + ">" + device + "</Device></Devices></Descriptions></EtherCATInfo>";
}

struct no_application {
    static object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = abort_code::no_object};
    }
    static abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return abort_code::no_object;
    }
};

/// The slave of a file, and a master that takes it to OP.
class bench {
  public:
    static constexpr std::uint16_t station = 0x1001;

    explicit bench(const std::string& xml)
        : device_{read(xml)}, objects_{device_, application_}, memory_(device_.transfer_size()) {
        objects_.show(slave());
        REQUIRE(run(bring_up{0, station}));
        REQUIRE(run(configure{station}).error() == master_error{});
        for (const auto state : {al_state::safe_op, al_state::op}) {
            CAPTURE(static_cast<int>(state));
            REQUIRE(run(change_state{station, state}).error() == master_error{});
        }
        CHECK(slave().state() == al_state::op);
    }
    template <master_job Job> typename Job::result_type run(const Job& job) { return net::run(link_, master_, job); }

    [[nodiscard]] ethercat::slave& slave() { return slave_[0]; }
    [[nodiscard]] const slave_record& record() { return *master_.find(station); }
    [[nodiscard]] std::string upload(std::uint16_t index, std::uint8_t subindex) {
        bytes data(100);
        const auto result = run(ethercat::upload{station, index, subindex, data});
        if (!result) return std::string{describe(result.error().abort)};
        return test::to_hex(*result);
    }
    abort_code download(std::uint16_t index, std::uint8_t subindex, const std::string& hex) {
        const auto data = test::from_hex(hex);
        return run(ethercat::download{station, index, subindex, data}).error().abort;
    }
    /// One cycle with `outputs`; the inputs that it brings.
    bytes exchange(const bytes& outputs) {
        REQUIRE(outputs.size() == data_->outputs(record()).size());
        std::ranges::copy(outputs, data_->outputs(record()).begin());
        bytes frame(max_frame_size);
        data_->begin_cycle();
        for (std::size_t size = 0; (size = data_->next_frame(frame, {})) != 0;) {
            const auto sent = std::span{frame}.first(size);
            slave().process(sent);
            REQUIRE(data_->on_frame(sent));
        }
        CHECK(data_->is_complete());
        const auto inputs = data_->inputs(record());
        return {inputs.begin(), inputs.end()};
    }
    void begin() { data_.emplace(master_.slaves()); }

  private:
    static esi::device read(const std::string& xml) {
        const auto made = esi::parse_esi(xml, "vendor.xml");
        INFO(made.error().message);
        REQUIRE(made);
        return *made;
    }

    no_application application_{};
    esi::emulated_device device_;
    esi::emulated_objects objects_;
    bytes memory_;
    std::array<ethercat::slave, 1> slave_{
        {ethercat::slave{device_.description(), objects_, {.transfer_memory = memory_}}}};
    loopback_link link_{slave_};
    master_for<16> master_{};
    std::optional<process_data_for<1, 2048>> data_{};
};

bytes of(const std::string& hex) { return test::from_hex(hex); }

const std::string type =
    R"(<Type ProductCode="#x12" RevisionNo="#x3">T-1</Type><Name>Thing</Name><GroupType>things</GroupType>)";
const std::string mailbox = R"(<Sm DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>
<Sm DefaultSize="128" StartAddress="#x1080" ControlByte="#x22" Enable="1">MBoxIn</Sm>)";

std::string data_type(const std::string& name, const std::string& items, int bits) {
    return "<DataType><Name>" + name + "</Name><BitSize>" + std::to_string(bits) + "</BitSize>" + items + "</DataType>";
}
std::string item(int subindex, const std::string& name, const std::string& of_type, const std::string& access) {
    return "<SubItem><SubIdx>" + std::to_string(subindex) + "</SubIdx><Name>" + name + "</Name><Type>" + of_type +
           "</Type><BitSize>0</BitSize><BitOffs>0</BitOffs><Flags><Access>" + access + "</Access></Flags></SubItem>";
}
std::string object(const std::string& index, const std::string& of_type, const std::string& info,
                   const std::string& access = "rw") {
    return "<Object><Index>" + index + "</Index><Name>Object " + index + "</Name><Type>" + of_type + "</Type><Info>" +
           info + "</Info><Flags><Access>" + access + "</Access></Flags></Object>";
}
std::string pdo(const std::string& kind, const std::string& attributes, const std::string& index,
                const std::string& entries) {
    return "<" + kind + " " + attributes + "><Index>" + index + "</Index><Name>" + index + "</Name>" + entries + "</" +
           kind + ">";
}
std::string entry(const std::string& index, int bits, const std::string& more = "") {
    return "<Entry><Index>" + index + "</Index>" + more + "<BitLen>" + std::to_string(bits) + "</BitLen></Entry>";
}

/// A drive with a choice of PDOs, a dictionary, start-up objects and times.
std::string drive() {
    return type + "<Info><StateMachine><Timeout><PreopTimeout>3000</PreopTimeout></Timeout></StateMachine></Info>" +
           "<Profile><ProfileNo>402</ProfileNo><Dictionary><DataTypes>" +
           data_type("DT1018",
                     item(0, "SubIndex 000", "USINT", "ro") + item(1, "Vendor", "UDINT", "ro") +
                         item(2, "Product", "UDINT", "ro") + item(3, "Revision", "UDINT", "ro") +
                         item(4, "Serial", "UDINT", "ro"),
                     144) +
           data_type("DT1600",
                     item(0, "SubIndex 000", "USINT", "rw") + item(1, "First", "UDINT", "rw") +
                         item(2, "Second", "UDINT", "rw") + item(3, "Third", "UDINT", "rw"),
                     112) +
           data_type("DT2000",
                     item(0, "SubIndex 000", "USINT", "ro") + item(1, "Gain", "UINT", "rw") +
                         item(3, "Model", "STRING(8)", "ro") + item(4, "Secret", "UDINT", "wo"),
                     128) +
           "</DataTypes><Objects>" + object("#x1000", "UDINT", "<DefaultData>92010200</DefaultData>", "ro") +
           object("#x1008", "STRING(8)", "<DefaultString>Thing</DefaultString>", "ro") +
           object("#x1018", "DT1018", "") + object("#x1600", "DT1600", "") +
           object("#x2000", "DT2000",
                  "<SubItem><Name>Model</Name><Info><DefaultString>M7</DefaultString></Info></SubItem>"
                  "<SubItem><Name>Gain</Name><Info><DefaultValue>#x0102</DefaultValue></Info></SubItem>") +
           object("#x6040", "UINT", "") + object("#x6041", "UINT", "", "ro") + object("#x6060", "SINT", "") +
           "</Objects></Dictionary></Profile><Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu><Fmmu>MBoxState</Fmmu>" + mailbox +
           R"(<Sm DefaultSize="3" StartAddress="#x1100" ControlByte="#x64" Enable="1">Outputs</Sm>)" +
           R"(<Sm DefaultSize="2" StartAddress="#x1200" ControlByte="#x20" Enable="1">Inputs</Sm>)" +
           pdo("RxPdo", R"(Sm="2")", "#x1600", entry("#x6040", 16) + entry("#x6060", 8)) +
           pdo("RxPdo", "", "#x1601", entry("#x6040", 16)) +
           pdo("TxPdo", R"(Sm="3" Fixed="1")", "#x1A00", entry("#x6041", 16, "<SubIndex>0</SubIndex>")) +
           R"(<Mailbox DataLinkLayer="1"><CoE SdoInfo="1" PdoAssign="1" CompleteAccess="0"><InitCmd>)"
           "<Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex><Data>08</Data></InitCmd></CoE><FoE/"
           "></Mailbox>"
           "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
           "<Eeprom><ByteSize>2048</ByteSize><ConfigData>0506</ConfigData></Eeprom>";
}

} // namespace

TEST_CASE("a drive of a vendor's file is taken to OP, with its PDOs and the values of its dictionary") {
    bench b{file_of(drive())};
    b.begin();
    b.slave().inputs()[0] = std::byte{0x37};
    CHECK(b.exchange(of("0F0008")) == of("3700"));
    CHECK(test::to_hex(b.slave().outputs()) == "0f 00 08");

    CHECK(b.upload(0x1000, 0) == "92 01 02 00");
    CHECK(b.upload(0x1008, 0) == "54 68 69 6e 67");
    CHECK(b.upload(0x1018, 1) == "12 ab 00 00"); // the file has no value
    CHECK(b.upload(0x1018, 2) == "12 00 00 00");
    CHECK(b.upload(0x1C00, 0) == "04");
    CHECK(b.upload(0x1C00, 3) == "03");
    CHECK(b.upload(0x1C12, 0) == "01");
    CHECK(b.upload(0x1C12, 1) == "00 16");
    CHECK(b.upload(0x1C13, 1) == "00 1a");
    CHECK(b.upload(0x1600, 0) == "02");
    CHECK(b.upload(0x1600, 2) == "08 00 60 60");
    CHECK(b.upload(0x1600, 3) == "00 00 00 00");
    CHECK(b.upload(0x1601, 1) == "10 00 40 60"); // not assigned, and not in the dictionary
    CHECK(b.upload(0x2000, 0) == "04");
    CHECK(b.upload(0x2000, 1) == "02 01");
    CHECK(b.upload(0x2000, 3) == "4d 37");
    CHECK(b.upload(0x6040, 0) == "0f 00"); // of the process data
    CHECK(b.upload(0x6041, 0) == "37 00");
    CHECK(b.upload(0x2000, 4) == describe(abort_code::write_only));
    CHECK(b.upload(0x2000, 2) == describe(abort_code::no_subindex));
    CHECK(b.upload(0x2001, 0) == describe(abort_code::no_object));

    CHECK(b.download(0x2000, 1, "0304") == abort_code::none);
    CHECK(b.upload(0x2000, 1) == "03 04");
    CHECK(b.download(0x2000, 1, "030405") == abort_code::length_too_high);
    CHECK(b.download(0x2000, 1, "03") == abort_code::length_too_low);
    CHECK(b.download(0x2000, 3, "30") == abort_code::read_only);
    CHECK(b.download(0x2000, 4, "01020304") == abort_code::none);
    // A master that writes the mapping which it has anyway is understood; another one is refused.
    CHECK(b.download(0x1600, 0, "00") == abort_code::none);
    CHECK(b.download(0x1600, 1, "10004060") == abort_code::none);
    CHECK(b.download(0x1600, 2, "10004060") == abort_code::value_range);
    CHECK(b.download(0x1600, 3, "08006060") == abort_code::value_range);
    CHECK(b.download(0x1600, 0, "02") == abort_code::none);
}

TEST_CASE("a slave of a file describes its objects where it has SDO information") {
    bench b{file_of(drive())};
    bytes into(100);
    const auto all = b.run(list_objects{.station = bench::station, .into = into});
    REQUIRE(all);
    std::vector<std::uint16_t> found;
    for (const auto index : *all) found.push_back(index);
    CHECK(found == std::vector<std::uint16_t>{0x1000, 0x1008, 0x1018, 0x1600, 0x1601, 0x1A00, 0x1C00, 0x1C12, 0x1C13,
                                              0x2000, 0x6040, 0x6041, 0x6060});
    const auto object = b.run(describe_object{bench::station, 0x2000, into});
    REQUIRE(object);
    CHECK(object->object.highest_subindex == 4);
    const auto gain = b.run(describe_entry{bench::station, 0x2000, 1, 0, into});
    REQUIRE(gain);
    CHECK(gain->entry.data_type == data_types::unsigned16);
    CHECK(gain->entry.bits == 16);
    CHECK(gain->entry.access.write_op);
}

TEST_CASE("terminals without a mailbox are taken to OP") {
    SECTION("inputs of some bits, in a SyncManager with control byte 0") {
        bench b{file_of(
            type +
            R"(<Fmmu>Inputs</Fmmu><Sm DefaultSize="1" StartAddress="#x1000" ControlByte="0" Enable="1">Inputs</Sm>)" +
            pdo("TxPdo", R"(Sm="0" Fixed="1")", "#x1A00", entry("#x6000", 1, "<SubIndex>1</SubIndex>")) +
            pdo("TxPdo", R"(Sm="0" Fixed="1")", "#x1A01", entry("#x6010", 1, "<SubIndex>1</SubIndex>")))};
        b.begin();
        b.slave().inputs()[0] = std::byte{2};
        CHECK(b.exchange({}) == of("02"));
    }
    SECTION("outputs in a register") {
        bench b{file_of(
            type +
            R"(<Fmmu>Outputs</Fmmu><Sm DefaultSize="1" StartAddress="#x0F00" ControlByte="#x44" Enable="#x09">Outputs</Sm>)" +
            pdo("RxPdo", R"(Sm="0")", "#x1600", entry("#x7000", 4, "<SubIndex>1</SubIndex>")))};
        b.begin();
        CHECK(b.exchange(of("05")).empty());
        CHECK(test::to_hex(b.slave().outputs()) == "05");
    }
    SECTION("two SyncManagers of outputs, and a virtual one of inputs") {
        bench b{file_of(type + R"(<Fmmu>Outputs</Fmmu><Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu>
<Sm DefaultSize="1" StartAddress="#x1100" ControlByte="#x44" Enable="1">Outputs</Sm>
<Sm DefaultSize="2" StartAddress="#x1200" ControlByte="#x44" Enable="1">Outputs</Sm>
<Sm StartAddress="#x0990" Virtual="true">Inputs</Sm>)" +
                        pdo("RxPdo", R"(Sm="0")", "#x1600", entry("#x7000", 1)) +
                        pdo("RxPdo", R"(Sm="1")", "#x1601", entry("#x7010", 16)) +
                        pdo("TxPdo", R"(Sm="2")", "#x1A00", entry("#x1D09", 32, "<SubIndex>152</SubIndex>")))};
        b.begin();
        CHECK(b.exchange(of("010203")).size() == 4);
        CHECK(test::to_hex(b.slave().outputs()) == "01 02 03");
    }
    SECTION("nothing at all: a coupler") {
        bench b{file_of(type, R"(Physics="YK")")};
        CHECK(b.upload(0x1000, 0) == describe(abort_code::none)); // it has no mailbox
    }
}

TEST_CASE("a slave is made of a file that leaves much out") {
    // No Physics, names, control bytes, Eeprom, dictionary; SoE beside CoE; slots.
    bench b{file_of(R"(<Type ProductCode=" 0x12 "/><Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu>
<Sm DefaultSize="64" StartAddress="0x1000">MBoxOut</Sm><Sm DefaultSize="64" StartAddress="0x1080">MBoxIn</Sm>
<Sm DefaultSize="0" StartAddress="#x1100">Outputs</Sm><Sm DefaultSize="6" StartAddress="#x1200">Inputs</Sm>
<TxPdo Sm="3"><Index>#x1A00</Index><Entry><Index>#x6000</Index><BitLen>8</BitLen></Entry><Entry><Index>0</Index><BitLen>40</BitLen></Entry></TxPdo>
<Mailbox><CoE/><SoE/></Mailbox><Slots><Slot MaxInstances="4"><ModuleIdent>#x1</ModuleIdent></Slot></Slots>)",
                    "")};
    b.begin();
    CHECK(b.exchange({}).size() == 6);
    CHECK(b.upload(0x1018, 1) == "12 ab 00 00");
    CHECK(b.upload(0x1C12, 0) == "00");
    CHECK(b.upload(0x1C13, 0) == "01");
    CHECK(b.upload(0x6000, 0) == "00");
    CHECK(b.upload(0x1A00, 2) == "28 00 00 00");
}

TEST_CASE("a slip costs the emulated slave its object alone") {
    auto xml = file_of(drive());
    const std::string wrong = "<Type>DT2000</Type>";
    xml.replace(xml.find(wrong), wrong.size(), "<Type>DT2001</Type>");
    bench b{xml};
    CHECK(b.upload(0x2000, 1) == describe(abort_code::no_object));
    CHECK(b.upload(0x1000, 0) == "92 01 02 00");
}

TEST_CASE("the SII of a device has its identity, mailbox, categories and memory") {
    const auto device = *esi::parse_esi(file_of(drive()), "vendor.xml");
    const auto sii = esi::device_sii(device);
    CHECK(sii.size() == 2048);
    CHECK(test::to_hex(std::span{sii}.first(14)) == "05 06 00 00 00 00 00 00 00 00 00 00 00 00");
    CHECK(std::to_integer<std::uint8_t>(sii[14]) == sii_checksum(std::span{sii}.first(14)));
    CHECK(test::to_hex(std::span{sii}.subspan(16, 12)) == "12 ab 00 00 12 00 00 00 03 00 00 00");
    CHECK(test::to_hex(std::span{sii}.subspan(48, 10)) == "00 10 80 00 80 10 80 00 0c 00"); // CoE and FoE
    CHECK(test::to_hex(std::span{sii}.subspan(124, 4)) == "0f 00 01 00");                   // 16 Kibit
    auto whole = device;
    whole.eeprom.image = bytes(256, std::byte{7});
    CHECK(esi::device_sii(whole) == bytes(256, std::byte{7}));
    whole = device;
    whole.eeprom.byte_size = 0xFFFFFFFF;
    CHECK(esi::device_sii(whole).size() == 0x20000);
}
