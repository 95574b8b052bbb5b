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

/// What the only slip of a document says, without the file and line.
std::string slip(const std::string& xml) {
    const auto read = parse(xml);
    if (!read) return "refused: " + read.error().message;
    if (read->slips.size() != 1) return std::to_string(read->slips.size()) + " slips";
    const auto& found = read->slips.front();
    const std::string start = "sample.xml:" + std::to_string(found.line) + ": ";
    CHECK(found.line != 0);
    CHECK(found.message.starts_with(start));
    return found.message.substr(start.size());
}
std::string slip_about(const std::string& from, const std::string& to) {
    return slip(replaced(sample_esi(), from, to));
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
    CHECK(slip(replaced(replaced(declared, "<BaseType>UDINT<", "<BaseType>DTEN1<"),
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

TEST_CASE("one of several devices is chosen by product code, revision or number") {
    const auto one = sample_esi();
    const auto at = one.find("<Device "), end = one.find("</Devices>");
    auto second = one.substr(at, end - at);
    second = replaced(replaced(second, "#x00000021", "#x00000022"), "#x00010002", "5");
    const auto third = replaced(second, "RevisionNo=\"5\"", "RevisionNo=\"8\"");
    const auto file = esi::esi_file::parse(replaced(one, "</Devices>", second + third + "</Devices>"), "sample.xml");
    REQUIRE(file);
    REQUIRE(file->devices().size() == 3);
    CHECK(file->devices()[0].product_code == 0x21);
    CHECK(file->devices()[0].revision == 0x10002);
    CHECK(file->devices()[2].revision == 8);
    CHECK(file->devices()[2].type == "A-1");
    CHECK(file->devices()[2].name == "arm <1>");
    CHECK(file->devices()[1].line > file->devices()[0].line);
    const auto revision = [&](const esi::device_choice& choice) { return file->read(choice)->revision; };
    CHECK(*file->read({.product = 0x21}) == test::sample_device());
    CHECK(revision({.product = 0x22, .revision = 8}) == 8);
    CHECK(revision({.product = 0x22, .revision = 5}) == 5);
    CHECK(revision({.number = 2}) == 8);
    CHECK(file->read({.revision = 5})->product_code == 0x22);
    // The newest revision below, of one product.
    CHECK(revision({.product = 0x22, .revision = 7}) == 5);
    CHECK(revision({.product = 0x22, .revision = 0xFFFFFFFF}) == 8);
    const auto why = [&](const esi::device_choice& choice) -> std::string {
        const auto read = file->read(choice);
        if (read) return "read";
        CHECK(read.error().code ==
              (read.error().message.find("second") != std::string::npos ? esi::errc::unexpected : esi::errc::missing));
        const auto& text = read.error().message;
        return text.substr(text.find('<'));
    };
    const std::string fifth = "1 (A-1, product #x00000022, revision #x00000005)",
                      eighth = "2 (A-1, product #x00000022, revision #x00000008)";
    CHECK(why({.product = 0x22, .revision = 4}) ==
          "<Devices>: no <Device> is product #x00000022, revision #x00000004 or older; there are numbers " + fifth +
              ", " + eighth);
    CHECK(why({.product = 0x22}) ==
          "<Device>: a second device that is product #x00000022, expected one; there are numbers " + fifth + ", " +
              eighth);
    CHECK(why({}) == "<Device>: a second device where none is chosen, expected one; there are "
                     "numbers 0 (A-1, product #x00000021, revision #x00010002), " +
                         fifth + ", " + eighth);
    CHECK(why({.product = 0x23}) == "<Devices>: no <Device> is product #x00000023");
    CHECK(why({.number = 3}) == "<Devices>: no <Device> is number 3");
    CHECK(why({.revision = 7}).starts_with("<Devices>: no <Device> is revision #x00000007 or older")); // of which?
    CHECK(esi::parse_esi(one, "sample.xml", {.product = 0x21, .revision = 0x10002}));
    CHECK(esi::parse_esi(one, "sample.xml", {.product = 0x21, .revision = 0x10003}));
    CHECK(!esi::parse_esi(one, "sample.xml", {.product = 0x21, .revision = 1}));
    CHECK(!esi::esi_file{}.read());
    // A number that cannot be read costs its device alone.
    const auto damaged = esi::esi_file::parse(
        replaced(one, "</Devices>", replaced(second, "\"5\"", "\"five\"") + third + "</Devices>"), "sample.xml");
    REQUIRE(damaged);
    CHECK(damaged->read({.number = 1}).error().code == esi::errc::invalid_value);
    CHECK(damaged->read({.product = 0x22, .revision = 8})->revision == 8);
    CHECK(esi::esi_file{}.modules().empty());
}

TEST_CASE("what vendors leave out has no value, and costs nothing") {
    const auto cut = [](std::string xml, const std::string& from, const std::string& to) {
        const auto begin = xml.find(from), end = xml.find(to, begin) + to.size();
        REQUIRE(begin != xml.npos);
        return xml.erase(begin, end - begin);
    };
    const auto differs = [](const std::string& xml, auto change) {
        auto expected = test::sample_device();
        change(expected);
        const auto read = parse(xml);
        INFO(read.error().message);
        for (const auto& each : read->slips) UNSCOPED_INFO(each.message);
        CHECK(*read == expected);
    };
    const auto sample = sample_esi();
    const auto vendor = sample.find("<Vendor>");
    differs(cut(sample, "<Name LcId", "</Name>"), [](auto& d) { d.vendor_name = ""; });
    REQUIRE(vendor != sample.npos);
    differs(replaced(sample, " Physics=\"YY\"", ""), [](auto& d) { d.physics = ""; });
    differs(replaced(sample, " ProductCode=\"#x00000021\"", ""), [](auto& d) { d.product_code = 0; });
    differs(replaced(sample, ">A-1</Type>", "/>"), [](auto& d) { d.type = ""; });
    differs(cut(sample, "<Eeprom>", "</Eeprom>"), [](auto& d) { d.eeprom = {}; });
    differs(cut(sample, "<ByteSize>", "</ByteSize>"), [](auto& d) { d.eeprom.byte_size = 0; });
    differs(cut(sample, "<GroupType>", "</GroupType>"), [](auto& d) { d.group_type = d.group_name = ""; });
    differs(cut(sample, "<Groups>", "</Groups>"), [](auto& d) {
        d.group_name = d.group_type;
        d.slips.push_back({esi::errc::unknown_reference, "GroupType", 13,
                           "sample.xml:13: <GroupType>: no <Group> has the type \"arms\""});
    });
    for (const auto* control : {" ControlByte=\"#x26\"", " ControlByte=\"#x22\"", " Enable=\"1\""})
        differs(replaced(sample, control, ""), [](auto&) {});
    differs(cut(cut(sample, "<BitSize>144", "</BitSize>"), "<BitSize>32", "</BitSize>"), [](auto&) {});

    const auto pdos = test::sample_esi_with_pdos();
    const auto whole = *parse(pdos);
    auto short_pdo = *parse(cut(pdos, "<SubIndex>", "</SubIndex>"));
    REQUIRE(!short_pdo.rx_pdos.empty());
    CHECK(short_pdo.rx_pdos[0].entries[0].subindex == 0);
    short_pdo.rx_pdos[0].entries[0].subindex = whole.rx_pdos[0].entries[0].subindex;
    CHECK(short_pdo == whole);
    const auto dynamic =
        *parse(replaced(pdos, "</RxPdo>", "</RxPdo><RxPdo><Index DependOnSlot=\"1\">#x1601</Index></RxPdo>"));
    REQUIRE(dynamic.rx_pdos.size() == whole.rx_pdos.size() + 1);
    CHECK(dynamic.rx_pdos[1] == esi::pdo{.index = 0x1601, .sync_manager = esi::not_assigned});
    const auto wide =
        *parse(replaced(pdos, "</RxPdo>", "<Entry><Index>0</Index><BitLen>4096</BitLen></Entry></RxPdo>"));
    CHECK(wide.rx_pdos[0].entries.back().bits == 4096);
}

TEST_CASE("numbers and names are read as vendors write them") {
    const auto sample = test::sample_device();
    const auto with = [&](const std::string& from, const std::string& to) {
        const auto read = parse(replaced(sample_esi(), from, to));
        INFO(to << read.error().message);
        CHECK(*read == sample);
    };
    for (const auto* id : {" #x000006A5\n", "0x6a5", "#X6A5", "#x 0000 06A5", "\t1701 "}) with("#x000006A5", id);
    with("\"#x00010002\"", "\" 0x00010002 \"");
    with("<ConfigData>80", "<ConfigData>\n 80 ");
    with("<Access>rw<", "<Access> RW <");
    with(">MBoxIn<", ">\n MBoxIn\n<");
    with("<Name LcId=\"1033\">arm &lt;1&gt;</Name>",
         "<Name LcId=\"1031\">Arm</Name><Name LcId=\"1033\"><![CDATA[ arm <1> ]]></Name>");
    // Latin-1, whatever the file declares; the line still counts.
    const auto latin = *parse(replaced(replaced(sample_esi(), ">A-1</Type>", ">1\xB5s</Type>"), "UTF-8", "ISO8859-1"));
    CHECK(latin.type == "1\xC2\xB5s");
    CHECK(parse(replaced(sample_esi(), ">A-1</Type>", ">1\xC2\xB5s</Type>"))->type == "1\xC2\xB5s");
}

TEST_CASE("start-up objects, slots, time-outs and protocols of a device are read and written") {
    auto device = test::sample_device();
    device.protocols = {"EoE", "FoE", "SoE"};
    device.start_up = {{.transitions = {"PS", "SO"},
                        .index = 0x60C2,
                        .subindex = 1,
                        .data = {std::byte{2}, std::byte{0xFD}},
                        .comment = "period"},
                       {.transitions = {"IP"}, .index = 0x1C12, .data = {std::byte{0}}, .complete_access = true}};
    device.slots = {{.name = "first", .min_instances = 1, .max_instances = 4, .module_idents = {0x10, 0x20}},
                    {.max_instances = 1, .module_classes = {"IO"}}};
    using std::chrono::milliseconds;
    device.timeouts = {.pre_op = milliseconds{3000},
                       .safe_op_op = milliseconds{9000},
                       .back_to_init = milliseconds{5000},
                       .back_to_safe_op = milliseconds{200},
                       .request = milliseconds{100},
                       .response = milliseconds{2000}};
    device.eeprom = {.image = {std::byte{1}, std::byte{2}}};
    CHECK(*parse(esi::write_esi(device)) == device);
    device.has_coe = false; // a mailbox with other protocols alone
    device.start_up.clear();
    device.objects.clear();
    device.coe = {};
    CHECK(*parse(esi::write_esi(device)) == device);
}

TEST_CASE("modules are read with their PDOs") {
    const std::string modules = "<Modules><Module><Type ModuleIdent=\"#x10\" ModuleClass=\"IO\">DI8</Type>"
                                "<Name LcId=\"1033\">eight inputs</Name>"
                                "<TxPdo><Index DependOnSlot=\"1\">#x1A00</Index><Name>in</Name><Entry>"
                                "<Index DependOnSlot=\"1\">#x6000</Index><SubIndex>1</SubIndex><BitLen>8</BitLen>"
                                "<Name>bits</Name><DataType>USINT</DataType></Entry></TxPdo>"
                                "<RxPdo><Name>no index</Name></RxPdo></Module>"
                                "<Module><Type ModuleIdent=\"32\"/></Module>"
                                "<Module><Type ModuleIdent=\"x\"/></Module></Modules>";
    const auto file = esi::esi_file::parse(replaced(sample_esi(), "</Devices>", "</Devices>" + modules), "sample.xml");
    REQUIRE(file);
    const auto read = file->modules();
    REQUIRE(read.size() == 3);
    const auto& first = read.front();
    CHECK(first.ident == 0x10);
    CHECK(first.module_class == "IO");
    CHECK(first.type == "DI8");
    CHECK(first.name == "eight inputs");
    CHECK(first.tx_pdos ==
          std::vector<esi::pdo>{
              {.index = 0x1A00,
               .name = "in",
               .sync_manager = esi::not_assigned,
               .entries = {{.index = 0x6000, .subindex = 1, .bits = 8, .name = "bits", .type = "USINT"}}}});
    REQUIRE(first.slips.size() == 1);
    CHECK(first.slips[0].code == esi::errc::missing);
    CHECK(read[1].ident == 32);
    CHECK(read[2].slips.size() == 1);
    CHECK(*file->read() == test::sample_device());
}

TEST_CASE("an object has the default values of its items by name") {
    const auto sample = test::sample_device();
    const auto xml = sample_esi();
    const auto info = xml.find("<Info>", xml.find("<Index>#x1018<"));
    const auto end = xml.find("</Object>", info);
    const auto with = [&](const std::string& items) {
        return xml.substr(0, info) + "<Info>" + items +
               "</Info><Flags><Access>ro</Access><Category>m</Category></Flags>" + xml.substr(end);
    };
    const auto item = [](const std::string& name, const std::string& data) {
        return "<SubItem><Name>" + name + "</Name><Info><DefaultData>" + data + "</DefaultData></Info></SubItem>";
    };
    const auto read = *parse(with(item("Product code", "21000000") + item("Vendor ID", "A5060000")));
    CHECK(read.slips.empty());
    REQUIRE(read.objects.size() == sample.objects.size());
    const auto& entries = read.objects[2].entries;
    REQUIRE(entries.size() == 5);
    CHECK(esi::hex_bytes(entries[1].default_data) == "A5060000");
    CHECK(esi::hex_bytes(entries[2].default_data) == "21000000");
    CHECK(entries[0].default_data.empty());
    CHECK(entries[3].default_data.empty());
    CHECK(slip(with(item("Colour", "00"))) == "<SubItem>: the object's type has no item \"Colour\"");
    CHECK(parse(with(item("Colour", "00")))->objects.size() == sample.objects.size() - 1);
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
    CHECK(slip(with("<Name>DC</Name>")) == "<OpMode>: expected a <AssignActivate> in it");
    CHECK(slip(with(named + "<CycleTimeSync0 Factor=\"32768\">0</CycleTimeSync0>")) ==
          "<CycleTimeSync0>: Factor=\"32768\", expected a number from -32768 to 32767");
    CHECK(slip(with(named + "<ShiftTimeSync1>soon</ShiftTimeSync1>")) ==
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
    const auto silent = parse(cut(sample_esi(), "<Mailbox", "</Mailbox>")); // its objects say that it has CoE
    REQUIRE(silent);
    CHECK(silent->has_coe);
    CHECK(silent->coe == esi::coe_features{});
}

TEST_CASE("text that is not an ESI document is reported as such") {
    CHECK(complaint("") == "not well-formed XML: No document element found");
    CHECK(complaint("<EtherCATInfo><Vendor></EtherCATInfo>").starts_with("not well-formed XML: "));
    CHECK(complaint("<EtherCATConfig/>") == "<EtherCATConfig>: the root element, expected <EtherCATInfo>");
    CHECK(complaint("<EtherCATInfo/>") == "<EtherCATInfo>: expected a <Device> in it");
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
    const auto check = [](const std::string& from, const std::string& to, esi::errc code, std::string_view element,
                          bool is_slip = false) {
        CAPTURE(to);
        const auto read = parse(replaced(sample_esi(), from, to));
        REQUIRE(read.has_value() == is_slip);
        REQUIRE((!is_slip || read->slips.size() == 1));
        const auto why = is_slip ? read->slips.front() : read.error();
        CHECK(why.code == code);
        CHECK(why.element == element);
        CHECK(describe(why.code) != "unknown error");
    };
    check("</EtherCATInfo>", "", esi::errc::not_xml, "");
    check("<Vendor>", "<Vendor/><Vendor>", esi::errc::missing, "Vendor");
    check("</Devices>", "<Device/></Devices>", esi::errc::unexpected, "Device");
    check(">MBoxIn<", ">mailbox<", esi::errc::invalid_value, "Sm", true);
    check("<Index>#x1018<", "<Index>#x1000<", esi::errc::duplicate, "Object", true);
    check("<GroupType>arms<", "<GroupType>legs<", esi::errc::unknown_reference, "GroupType", true);
    check("<SubIdx>26<", "<SubIdx>0<", esi::errc::inconsistent, "SubIdx", true);
    CHECK(parse("<EtherCATConfig/>").error().code == esi::errc::not_esi);
    CHECK(esi::read_esi("/no/such/file.xml").error().code == esi::errc::unreadable);
}

TEST_CASE("a wrong number outside the dictionary is reported with its element") {
    CHECK(complaint_about("RevisionNo=\"#x00010002\"", "RevisionNo=\"2x\"") ==
          "<Type>: RevisionNo=\"2x\", expected a number such as #x1A or 26, at most 4294967295");
    CHECK(complaint_about("<ConfigData>80", "<ConfigData>8") ==
          "<ConfigData>: expected hexadecimal digits, two for each byte");
    CHECK(complaint_about("StartAddress=\"#x1600\"", "StartAddress=\"#x10000\"") ==
          "<Sm>: StartAddress=\"#x10000\", expected a number such as #x1A or 26, at most 65535");
    CHECK(complaint_about("SdoInfo=\"true\"", "SdoInfo=\"no\"") == "<CoE>: SdoInfo=\"no\", expected true or false");
}

TEST_CASE("a slip costs the part of the file that it is in, and says where it is") {
    CHECK(slip_about("<GroupType>arms<", "<GroupType>legs<") == "<GroupType>: no <Group> has the type \"legs\"");
    const auto sync_manager = parse(replaced(sample_esi(), ">MBoxIn<", ">mailbox<"));
    REQUIRE(sync_manager);
    CHECK(sync_manager->sync_managers[1].use == ethercat::sii_sync_manager_use::none);
    CHECK(slip_about(">MBoxIn<", ">mailbox<") == "<Sm>: \"mailbox\", expected MBoxOut, MBoxIn, Outputs or Inputs");

    // Objects: each of these costs one of them.
    const auto object_slip = [](const std::string& from, const std::string& to) {
        const auto xml = replaced(sample_esi(), from, to);
        if (const auto read = parse(xml)) CHECK(read->objects.size() == test::sample_device().objects.size() - 1);
        return slip(xml);
    };
    CHECK(object_slip("<Type>DT1018</Type>", "<Type>DT1019</Type>") ==
          "<Object>: its type \"DT1019\" is no base type; expected a <DataType> of that name in <DataTypes>");
    CHECK(object_slip("<Type>DT1018</Type>\n                <BitSize>144<",
                      "<Type>DT1018</Type>\n                <BitSize>143<") ==
          "<BitSize>: expected 144, the size of DT1018");
    CHECK(object_slip("<Index>#x1018<", "<Index>#x1000<") ==
          "<Object>: object #x1000 is there twice, expected each once");
    CHECK(object_slip("<Index>#x1018<", "<Index>#x101Z<") ==
          "<Index>: \"#x101Z\", expected a number such as #x1A or 26, at most 65535");
    CHECK(object_slip("<DefaultData>A5060000<", "<DefaultData>A506000000<") ==
          "<DefaultData>: 5 bytes, expected at most 4");
    CHECK(object_slip("<DefaultData>A5060000</DefaultData>", "<DefaultValue>one</DefaultValue>") ==
          "<DefaultValue>: \"one\", expected a number that UDINT holds, or <DefaultData> in its place");
    CHECK(object_slip("<Access>wo<", "<Access>w<") == "<SubItem>: access \"w\", expected ro, wo or rw");
    CHECK(object_slip("<SubIdx>26<", "<SubIdx>0<") == "<SubIdx>: expected ascending subindices");
    CHECK(object_slip("<SubIdx>26<", "<SubIdx>256<") ==
          "<SubIdx>: \"256\", expected a number such as #x1A or 26, at most 255");
    CHECK(object_slip("<Type>OCTET_STRING(28)<", "<Type>OCTETS<") ==
          "<SubItem>: its type \"OCTETS\" is unknown; expected a base type such as OCTET_STRING(28)");
    CHECK(object_slip("<LBound>1<", "<LBound>0<") == "<LBound>: expected 1, the first subindex");
    CHECK(object_slip("<SubIdx>0<", "<SubIdx>1<") == "<SubIdx>: expected ascending subindices");
    CHECK(object_slip("                  <Type>USINT<", "                  <Type>UDINT<") ==
          "<DataType>: expected a <SubItem> with <SubIdx> 0 of type USINT first");
    CHECK(object_slip("<SubItem>\n                    <Name>Vendor ID<",
                      "<SubItem><Name>a</Name></SubItem><SubItem>\n                    <Name>Vendor ID<") ==
          "<SubItem>: the object's type has no item \"a\"");

    const auto two =
        parse(replaced(replaced(sample_esi(), "<Index>#x1018<", "<Index>other<"), "<SubIdx>26<", "<SubIdx>0<"));
    REQUIRE(two);
    CHECK(two->slips.size() == 2);
    CHECK(two->objects.size() == test::sample_device().objects.size() - 2);

    const auto pdo = parse(replaced(test::sample_esi_with_pdos(), "<BitLen>", "<BitLen>x"));
    REQUIRE(pdo);
    CHECK(pdo->slips.size() == 1);
    CHECK(pdo->rx_pdos.empty());
    CHECK(!pdo->tx_pdos.empty());
}

TEST_CASE("the elements of an object are one array, directly after subindex 0") {
    const std::string xml = sample_esi(), name = "<Name>Elements</Name>";
    const auto at = xml.find(name);
    REQUIRE(at != xml.npos);
    const std::string end = "</Type>", item = xml.substr(at, xml.find(end, at) + end.size() - at);
    const std::string next = "</SubItem><SubItem>" + name, plain = "<Type>USINT</Type>";
    CHECK(slip_about(name, item + next) == "<SubItem>: an item behind the elements of an array, expected none there");
    CHECK(slip_about(name, item + "</SubItem><SubItem><SubIdx>255</SubIdx><Name>a</Name>" + plain + next) ==
          "<SubItem>: an item behind the elements of an array, expected none there");
    CHECK(slip_about(name, "<SubIdx>1</SubIdx><Name>a</Name>" + plain + next) ==
          "<SubItem>: the elements of an array behind a record's items, expected them behind subindex 0 alone");
}

TEST_CASE("a device has no more SyncManagers than a slave") {
    auto device = test::sample_device();
    device.sync_managers.resize(16, device.sync_managers.back());
    CHECK(*parse(esi::write_esi(device)) == device);
    device.sync_managers.push_back(device.sync_managers.back());
    CHECK(complaint(esi::write_esi(device)) == "<Sm>: expected at most 16 <Sm>: a slave has no more");
}

TEST_CASE("types that a file declares by their size alone are base types") {
    const auto own = replaced(
        replaced(sample_esi(), "<DataTypes>", "<DataTypes><DataType><Name>DAYS</Name><BitSize>32</BitSize></DataType>"),
        "<Name>Vendor ID</Name>\n                  <Type>UDINT<", "<Name>Vendor ID</Name><Type>DAYS<");
    const auto read = parse(own);
    REQUIRE(read);
    CHECK(read->slips.empty());
    CHECK(read->objects[2].entries[1].type == "DAYS");
    CHECK(read->objects[2].entries[1].bit_size == 32);
}
