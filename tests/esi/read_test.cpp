// Reading ESI files: written files are restored, variants of other writers are accepted, and each fault is reported.
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/text_values.hpp>

#include <fstream>

using namespace jauscat;
using test::replaced;
using test::sample_esi;

namespace {

auto parse(const std::string& xml) { return esi::parse_esi(xml, "sample.xml"); }

/// The reader's message, without the file and line.
std::string complaint(const std::string& xml) {
    const auto read = parse(xml);
    if (read) return "accepted";
    const std::string text{describe(read.error())};
    const std::string start = "sample.xml:" + std::to_string(read.error().line) + ": ";
    CHECK(text.starts_with(start));
    return text.substr(start.size());
}

/// The message for the sample with one text replaced.
std::string complaint_about(const std::string& from, const std::string& to) {
    return complaint(replaced(sample_esi(), from, to));
}

} // namespace

TEST_CASE("reading a written device restores it") {
    CHECK(*parse(sample_esi()) == test::sample_device());

    auto device = test::sample_device();
    device.serial = 7;
    device.physics = "Y K";
    device.profile = 5001;
    device.fmmus = {"Outputs", "Inputs", "MBoxState"};
    device.sync_managers[0].min_size = 34;
    device.sync_managers[1].max_size = 1486;
    device.sync_managers.push_back(
        {.use = ethercat::sii_sync_manager_use::inputs, .start = 0x1900, .default_size = 4, .control = 0x20});
    device.coe = {.sdo_information = true, .pdo_assign = true, .pdo_configuration = true, .complete_access = true};
    device.eeprom = {.byte_size = 2048,
                     .config_data = std::vector<std::byte>(14, std::byte{0xFE}),
                     .bootstrap = std::vector<std::byte>(8, std::byte{1})};
    device.objects[0].entries[0].writable = true;
    device.objects[4].properties.push_back({"Colour", "<red> & \"blue\""});
    CHECK(*parse(esi::write_esi(device)) == device);
}

TEST_CASE("variants written by other tools are accepted") {
    const auto sample = test::sample_device();
    CHECK(*parse(replaced(sample_esi(), "#x000006A5", "1701")) == sample);
    CHECK(*parse(replaced(sample_esi(), "#x000006A5", "#x6a5")) == sample);
    CHECK(*parse(replaced(sample_esi(), "\"#x26\"", "\"38\"")) == sample);
    CHECK(*parse(replaced(sample_esi(), "SdoInfo=\"true\"", "SdoInfo=\"1\"")) == sample);
    CHECK(*parse(replaced(sample_esi(), " PdoAssign=\"false\"", "")) == sample);
    CHECK(*parse(replaced(sample_esi(), "<Vendor>", "<!-- who -->\n<Vendor FileVersion=\"3\">")) == sample);
    CHECK(*parse(replaced(sample_esi(), "<GroupType>", "<Info/><GroupType>")) == sample);
    CHECK(*parse("\xEF\xBB\xBF" + sample_esi()) == sample); // byte order mark
    CHECK(*parse(replaced(sample_esi(), "<DefaultData>61726D203C313E</DefaultData>",
                          "<DefaultString>arm &lt;1&gt;</DefaultString>")) == sample);

    auto text = sample_esi(); // the name that IEC 61131 has for an octet string
    for (int i = 0; i != 2; ++i) text = replaced(text, "<Type>OCTET_STRING(28)<", "<Type>ARRAY [0..27] OF BYTE<");
    const auto octets = *parse(text);
    REQUIRE(octets.objects.size() == sample.objects.size());
    CHECK(octets.objects[4].entries[1].type == "ARRAY [0..27] OF BYTE");
    CHECK(octets.objects[4].entries[1].bit_size == 224);
}

TEST_CASE("defaults as numbers, enumerations and PDOs that are not assigned are read") {
    const auto sample = test::sample_device();
    const std::string data = "<DefaultData>A5060000</DefaultData>";
    for (const auto* value : {"1701", "#x6A5", "#x000006a5"})
        CHECK(*parse(replaced(sample_esi(), data, "<DefaultValue>" + std::string{value} + "</DefaultValue>")) ==
              sample);

    CHECK(*parse(replaced(sample_esi(), "<Type>DT1018</Type>\n                <BitSize>144<",
                          "<Type>DT1018</Type>\n                <BitSize>152<")) == sample); // aligned

    // 1018h:1 as an enumeration of an enumeration.
    const auto enumeration = [](const std::string& name, const std::string& base) {
        return "<DataType><Name>" + name + "</Name><BaseType>" + base + "</BaseType><BitSize>32</BitSize>" +
               "<EnumInfo><Text>one</Text><Enum>1</Enum></EnumInfo></DataType>";
    };
    const auto declared = replaced(sample_esi(), "<DataTypes>",
                                   "<DataTypes>" + enumeration("DTEN1", "DTEN2") + enumeration("DTEN2", "UDINT"));
    const std::string name = "<Name>Vendor ID</Name>", spaces(18, ' ');
    CHECK(*parse(replaced(declared, name + '\n' + spaces + "<Type>UDINT<", name + "<Type>DTEN1<")) == sample);
    // A type that is its own base ends the search.
    CHECK(complaint(replaced(replaced(declared, "<BaseType>UDINT<", "<BaseType>DTEN1<"),
                             name + '\n' + spaces + "<Type>UDINT<", name + "<Type>DTEN1<"))
              .find("is unknown; expected a base type") != std::string::npos);

    const auto pdos = replaced(test::sample_esi_with_pdos(), "<RxPdo Sm=\"2\"", "<RxPdo");
    const auto read = *parse(pdos);
    REQUIRE(read.rx_pdos.size() == 1);
    CHECK(read.rx_pdos[0].sync_manager == esi::not_assigned);
    CHECK(*parse(esi::write_esi(read)) == read);
}

TEST_CASE("a number as text has the bytes of its base type") {
    const auto hex = [](const char* text, const char* type) -> std::string {
        const auto value = esi::parse_value(text, type);
        return value ? esi::hex_bytes(*value) : "none";
    };
    CHECK(hex("#x12", "USINT") == "12");
    CHECK(hex("255", "USINT") == "FF");
    CHECK(hex("256", "USINT") == "none");
    CHECK(hex("-128", "SINT") == "80");
    CHECK(hex("-129", "SINT") == "none");
    CHECK(hex("-2", "DINT") == "FEFFFFFF");
    CHECK(hex("-9223372036854775808", "LINT") == "0000000000000080");
    CHECK(hex("#xFFFFFFFFFFFFFFFF", "ULINT") == "FFFFFFFFFFFFFFFF");
    CHECK(hex("18446744073709551616", "ULINT") == "none");
    CHECK(hex("1", "BOOL") == "01");
    CHECK(hex("5", "BIT3") == "05");
    CHECK(hex("8", "BIT3") == "none");
    CHECK(hex("0.5", "REAL") == "0000003F");
    CHECK(hex("-2", "LREAL") == "00000000000000C0");
    for (const auto* wrong : {"", "#x", "-", "1.5", "one", "0x1"}) CHECK(hex(wrong, "UDINT") == "none");
    CHECK(hex("1", "STRING(4)") == "none");
}

TEST_CASE("one of several devices is chosen by product code and revision") {
    const auto one = sample_esi();
    const auto at = one.find("<Device "), end = one.find("</Devices>");
    auto second = one.substr(at, end - at);
    second = replaced(replaced(second, "#x00000021", "#x00000022"), "#x00010002", "5");
    const auto third = replaced(second, "RevisionNo=\"5\"", "RevisionNo=\"6\"");
    const auto several = replaced(one, "</Devices>", second + third + "</Devices>");
    const auto chosen = [&](const esi::device_choice& choice) { return esi::parse_esi(several, "sample.xml", choice); };
    CHECK(complaint(several) == "<Device>: a second device, expected one in a file");
    CHECK(*chosen({.product = 0x21}) == test::sample_device());
    CHECK(chosen({.product = 0x22, .revision = 6})->revision == 6);
    CHECK(chosen({.revision = 5})->product_code == 0x22);
    CHECK(chosen({.product = 0x22}).error().code == esi::errc::unexpected);
    CHECK(chosen({.product = 0x23}).error().code == esi::errc::missing);
    CHECK(esi::parse_esi(one, "sample.xml", {.product = 0x21, .revision = 0x10002}));
    CHECK(!esi::parse_esi(one, "sample.xml", {.product = 0x21, .revision = 1}));
}

TEST_CASE("modes of a distributed clock are read, with defaults and with wrong values") {
    const auto with = [](const std::string& content) {
        return replaced(sample_esi(), "</Mailbox>",
                        "</Mailbox><Dc UnknownFRMW=\"1\"><OpMode>" + content + "</OpMode></Dc>");
    };
    const auto only = *parse(with("<Name>DC</Name><AssignActivate>#x300</AssignActivate>"
                                  "<CycleTimeSync0>2000</CycleTimeSync0><ShiftTimeSync0>-5</ShiftTimeSync0>"
                                  "<CycleTimeSync1 Factor=\"-3\">7</CycleTimeSync1>"));
    CHECK(only.clock_modes == std::vector<esi::clock_mode>{{.name = "DC",
                                                            .assign_activate = 0x300,
                                                            .cycle_time_0 = 2000,
                                                            .shift_time_0 = -5,
                                                            .cycle_time_1 = 7,
                                                            .cycle_factor_1 = -3}});
    CHECK(*parse(esi::write_esi(only)) == only);
    const std::string named = "<Name>DC</Name><AssignActivate>#x300</AssignActivate>";
    CHECK(complaint(with("<Name>DC</Name>")) == "<OpMode>: expected a <AssignActivate> in it");
    CHECK(complaint(with(named + "<CycleTimeSync0 Factor=\"32768\">0</CycleTimeSync0>")) ==
          "<CycleTimeSync0>: Factor=\"32768\", expected a number from -32768 to 32767");
    CHECK(complaint(with(named + "<ShiftTimeSync1>soon</ShiftTimeSync1>")) ==
          "<ShiftTimeSync1>: \"soon\", expected a number from -2147483648 to 2147483647");
}

TEST_CASE("a device without CoE, or without an offline dictionary, is read") {
    const auto cut = [](std::string xml, const std::string& from, const std::string& to) {
        const auto begin = xml.find(from), end = xml.find(to) + to.size();
        return xml.erase(begin, end - begin);
    };
    const auto online = cut(sample_esi(), "<Profile>", "</Profile>");
    const auto read = parse(online);
    REQUIRE(read);
    CHECK(read->has_coe);
    CHECK(read->objects.empty());
    const auto simple = parse(cut(online, "<Mailbox", "</Mailbox>"));
    REQUIRE(simple);
    CHECK(!simple->has_coe);
    CHECK(simple->coe == esi::coe_features{});
    CHECK(complaint(cut(sample_esi(), "<Mailbox", "</Mailbox>")) == "<Device>: expected a <Mailbox> in it");
}

TEST_CASE("text that is not an ESI document is reported as such") {
    CHECK(complaint("") == "not well-formed XML: No document element found");
    CHECK(complaint("<EtherCATInfo><Vendor></EtherCATInfo>").starts_with("not well-formed XML: "));
    CHECK(complaint("<EtherCATConfig/>") == "<EtherCATConfig>: the root element, expected <EtherCATInfo>");
    CHECK(complaint("<EtherCATInfo/>") == "<EtherCATInfo>: expected a <Vendor> in it");
    CHECK(describe(esi::read_esi("/no/such/file.xml").error()) ==
          "/no/such/file.xml: cannot be read: No such file or directory");
    CHECK(describe(esi::read_esi("/").error()) == "/: cannot be read: Is a directory");
}

TEST_CASE("an error states its line") {
    const auto read = parse(replaced(sample_esi(), "#x000006A5", "much"));
    CHECK(read.error() ==
          esi::error{.code = esi::errc::invalid_value,
                     .element = "Id",
                     .line = 4,
                     .message =
                         "sample.xml:4: <Id>: \"much\", expected a number such as #x1A or 26, at most 4294967295"});
}

TEST_CASE("each error of an ESI file has a code and the element concerned") {
    const auto check = [](const std::string& from, const std::string& to, esi::errc code, std::string_view element) {
        CAPTURE(to);
        const auto why = parse(replaced(sample_esi(), from, to)).error();
        CHECK(why.code == code);
        CHECK(why.element == element);
        CHECK(describe(why.code) != "unknown error");
    };
    check("</EtherCATInfo>", "", esi::errc::not_xml, "");
    check(" Physics=\"YY\"", "", esi::errc::missing, "Device");
    check(">A-1</Type>", "/>", esi::errc::missing, "Type");
    check("</Devices>", "<Device/></Devices>", esi::errc::unexpected, "Device");
    check(">MBoxIn<", ">MboxIn<", esi::errc::invalid_value, "Sm");
    check("<Index>#x1018<", "<Index>#x1000<", esi::errc::duplicate, "Dictionary");
    check("<GroupType>arms<", "<GroupType>legs<", esi::errc::unknown_reference, "GroupType");
    check("<SubIdx>26<", "<SubIdx>0<", esi::errc::inconsistent, "SubIdx");
    CHECK(parse("<EtherCATConfig/>").error().code == esi::errc::not_esi);
    CHECK(esi::read_esi("/no/such/file.xml").error().code == esi::errc::unreadable);
}

TEST_CASE("a missing or wrong value is reported with its element") {
    CHECK(complaint_about(" Physics=\"YY\"", "") == "<Device>: expected an attribute Physics");
    CHECK(complaint_about(" ProductCode=\"#x00000021\"", "") == "<Type>: expected an attribute ProductCode");
    CHECK(complaint_about("RevisionNo=\"#x00010002\"", "RevisionNo=\"0x2\"") ==
          "<Type>: RevisionNo=\"0x2\", expected a number such as #x1A or 26, at most 4294967295");
    CHECK(complaint_about("<GroupType>arms<", "<GroupType>legs<") == "<GroupType>: no <Group> has the type \"legs\"");
    CHECK(complaint_about(">A-1</Type>", "/>") == "<Type>: expected a text in it");
    CHECK(complaint_about("<ByteSize>512</ByteSize>", "") == "<Eeprom>: expected a <ByteSize> in it");
    CHECK(complaint_about("<ConfigData>80", "<ConfigData>8") ==
          "<ConfigData>: expected hexadecimal digits, two for each byte");
    CHECK(complaint_about(">MBoxIn<", ">MboxIn<") == "<Sm>: \"MboxIn\", expected MBoxOut, MBoxIn, Outputs or Inputs");
    CHECK(complaint_about("StartAddress=\"#x1600\"", "StartAddress=\"#x10000\"") ==
          "<Sm>: StartAddress=\"#x10000\", expected a number such as #x1A or 26, at most 65535");
    CHECK(complaint_about("SdoInfo=\"true\"", "SdoInfo=\"no\"") == "<CoE>: SdoInfo=\"no\", expected true or false");
    CHECK(complaint_about("</Devices>", "<Device/></Devices>") == "<Device>: a second device, expected one in a file");
}

TEST_CASE("objects that do not fit their types are reported") {
    CHECK(complaint_about("<Type>DT1018</Type>", "<Type>DT1019</Type>") ==
          "<Object>: its type \"DT1019\" is no base type; expected a <DataType> of that name in <DataTypes>");
    CHECK(complaint_about("<Type>DT1018</Type>\n                <BitSize>144<",
                          "<Type>DT1018</Type>\n                <BitSize>143<") ==
          "<BitSize>: expected 144, the size of DT1018");
    CHECK(complaint_about("<Index>#x1018<", "<Index>#x1000<") ==
          "<Dictionary>: object #x1000 is there twice, expected each once");
    CHECK(complaint_about("<DefaultData>A5060000<", "<DefaultData>A506000000<") ==
          "<DefaultData>: 5 bytes, expected at most 4");
    CHECK(complaint_about("<DefaultData>A5060000</DefaultData>", "<DefaultValue>one</DefaultValue>") ==
          "<DefaultValue>: \"one\", expected a number that UDINT holds, or <DefaultData> in its place");
    CHECK(complaint_about("<Access>wo<", "<Access>w<") == "<SubItem>: access \"w\", expected ro, wo or rw");
    CHECK(complaint_about("<SubIdx>26<", "<SubIdx>0<") == "<SubIdx>: expected ascending subindices");
    CHECK(complaint_about("<SubIdx>26<", "<SubIdx>256<") ==
          "<SubIdx>: \"256\", expected a number such as #x1A or 26, at most 255");
    CHECK(complaint_about("<Type>OCTET_STRING(28)<", "<Type>OCTETS<") ==
          "<SubItem>: its type \"OCTETS\" is unknown; expected a base type such as OCTET_STRING(28)");
    CHECK(complaint_about("<LBound>1<", "<LBound>0<") == "<LBound>: expected 1, the first subindex");
    CHECK(complaint_about("<SubIdx>0<", "<SubIdx>1<") == "<SubIdx>: expected ascending subindices");
    CHECK(complaint_about("                  <Type>USINT<", "                  <Type>SINT<") ==
          "<DataType>: expected a <SubItem> with <SubIdx> 0 of type USINT first");
    CHECK(complaint_about("<SubItem>\n                    <Name>Vendor ID</Name>\n                    <Info>\n"
                          "                      <DefaultData>A5060000</DefaultData>\n                    </Info>\n"
                          "                  </SubItem>",
                          "") == "<Info>: expected 5 <SubItem>, one for each of the object's type");
    CHECK(complaint_about("<SubItem>\n                    <Name>Vendor ID<",
                          "<SubItem><Name>a</Name></SubItem><SubItem>\n                    <Name>Vendor ID<") ==
          "<SubItem>: more items than the object's type has");
}

TEST_CASE("the elements of an object are one array, directly after subindex 0") {
    const std::string xml = sample_esi(), name = "<Name>Elements</Name>";
    const auto at = xml.find(name);
    REQUIRE(at != xml.npos);
    const std::string end = "</Type>", item = xml.substr(at, xml.find(end, at) + end.size() - at);
    const std::string next = "</SubItem><SubItem>" + name, plain = "<Type>USINT</Type>";
    CHECK(complaint_about(name, item + next) ==
          "<SubItem>: an item behind the elements of an array, expected none there");
    CHECK(complaint_about(name, item + "</SubItem><SubItem><SubIdx>255</SubIdx><Name>a</Name>" + plain + next) ==
          "<SubItem>: an item behind the elements of an array, expected none there");
    CHECK(complaint_about(name, "<SubIdx>1</SubIdx><Name>a</Name>" + plain + next) ==
          "<SubItem>: the elements of an array behind a record's items, expected them behind subindex 0 alone");
}

TEST_CASE("a device has no more SyncManagers than a slave") {
    auto device = test::sample_device();
    device.sync_managers.resize(16, device.sync_managers.back());
    CHECK(*parse(esi::write_esi(device)) == device);
    device.sync_managers.push_back(device.sync_managers.back());
    CHECK(complaint(esi::write_esi(device)) == "<Sm>: expected at most 16 <Sm>: a slave has no more");
}
