// The check of ESI files: a complete file passes, and each removed or invalid part is reported by name.
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/requirements.hpp>

#include <pugixml.hpp>

#include <sstream>

using namespace jauscat;
using test::replaced;
using test::sample_esi;

namespace {

std::string problem(const std::string& xml, std::string_view what) {
    const auto findings = esi::check_esi_text(xml, "sample.xml");
    REQUIRE(findings);
    for (const auto& each : *findings)
        if (each.what == what) return each.problem;
    return "no such finding";
}

std::string text_of(const pugi::xml_document& document) {
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

/// The first element at the path, or the one with its attribute.
pugi::xml_node element_at(const pugi::xml_document& document, std::string_view path) {
    const auto place = path.substr(0, path.find("/@"));
    return document.select_node(("/EtherCATInfo/" + std::string{place}).c_str()).node();
}

} // namespace

TEST_CASE("a written file has everything that tools require") {
    const auto findings = *esi::check_esi_text(sample_esi(), "sample.xml");
    CHECK(findings.size() > esi::requirements.size());
    for (const auto& each : findings) {
        INFO(each.what);
        CHECK(each.problem == "");
        CHECK(!each.reason.empty());
    }
}

TEST_CASE("each missing required element or attribute is reported by name") {
    for (const auto& wanted : esi::requirements) {
        INFO(wanted.path);
        pugi::xml_document document;
        REQUIRE(document.load_string(test::sample_esi_with_pdos().c_str()));
        auto element = element_at(document, wanted.path);
        REQUIRE(element);
        if (const auto at = wanted.path.find("/@"); at != wanted.path.npos) {
            REQUIRE(element.remove_attribute(std::string{wanted.path.substr(at + 2)}.c_str()));
        } else {
            // All of that name, so that where one of several is enough none is left.
            auto parent = element.parent();
            while (parent.remove_child(element.name())) {}
        }
        const auto said = problem(text_of(document), wanted.path);
        CHECK(said != "no such finding");
        CHECK(said != "");
    }
}

TEST_CASE("each invalid required text or number is reported by name") {
    for (const auto& wanted : esi::requirements) {
        if (wanted.holds == esi::content::element) continue;
        INFO(wanted.path);
        pugi::xml_document document;
        REQUIRE(document.load_string(test::sample_esi_with_pdos().c_str()));
        auto element = element_at(document, wanted.path);
        const char* const spoilt = wanted.holds == esi::content::text ? "" : "0x1A";
        if (const auto at = wanted.path.find("/@"); at != wanted.path.npos) {
            REQUIRE(element.attribute(std::string{wanted.path.substr(at + 2)}.c_str()).set_value(spoilt));
        } else {
            REQUIRE(element.text().set(spoilt));
        }
        const auto said = problem(text_of(document), wanted.path);
        CHECK(said.starts_with("line "));
        CHECK(said.find("expected") != said.npos);
    }
}

TEST_CASE("a problem is reported with line and element") {
    const auto xml = sample_esi();
    CHECK(problem(replaced(xml, "    <Id>#x000006A5</Id>\n", ""), "Vendor/Id") == "line 3: <Vendor>: has no <Id>");
    CHECK(problem(replaced(xml, "#x000006A5", "0x6A5"), "Vendor/Id") ==
          "line 4: <Id>: \"0x6A5\", expected a number such as #x1A or 26");
    CHECK(problem(replaced(xml, " Physics=\"YY\"", ""), "Descriptions/Devices/Device/@Physics") ==
          "line 15: <Device>: has no attribute Physics");
    CHECK(problem(replaced(xml, "<Access>wo<", "<Access>w<"),
                  "Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/Flags/Access")
              .ends_with("<Access>: \"w\", expected ro, wo or rw"));
    CHECK(problem("<EtherCATInfo/>", "Vendor") == "line 1: <EtherCATInfo>: has no <Vendor>");
    for (const auto* rule : {"Vendor/Id", "SyncManagers 0 and 1 are the mailbox",
                             "ConfigData has the SII's words 0 to 6", "object #x1018, identity"})
        CHECK(problem("<EtherCATInfo/>", rule) == "its parent is missing");
}

TEST_CASE("a check tells apart what the schema demands, the standard advises and the emulated device needs") {
    const auto missing = [](const std::string& xml, esi::demand by) {
        std::vector<std::string> made;
        const auto findings = esi::check_esi_text(xml, "sample.xml");
        REQUIRE(findings);
        for (const auto& each : *findings)
            if (each.by == by && !each.met()) made.push_back(each.what);
        return made;
    };
    using list = std::vector<std::string>;
    const auto xml = sample_esi();
    const auto without = [&](const std::string& text) { return replaced(xml, text, ""); };
    for (const auto by : {esi::demand::schema, esi::demand::standard, esi::demand::emulation})
        CHECK(missing(xml, by).empty());
    CHECK(missing(without(" Physics=\"YY\""), esi::demand::schema) == list{"Descriptions/Devices/Device/@Physics"});
    CHECK(missing(without(" Physics=\"YY\""), esi::demand::standard).empty());
    CHECK(missing(without(" ControlByte=\"#x26\""), esi::demand::schema).empty());
    CHECK(missing(without(" ControlByte=\"#x26\""), esi::demand::standard) ==
          list{"Descriptions/Devices/Device/Sm/@ControlByte"});
    const auto begin = xml.find("<Profile>"), end = xml.find("</Profile>") + 10;
    const auto online = xml.substr(0, begin) + xml.substr(end); // the dictionary is read from the device
    CHECK(missing(online, esi::demand::schema).empty());
    CHECK(missing(online, esi::demand::standard).empty());
    CHECK(!missing(online, esi::demand::emulation).empty());
    const auto other = replaced(online, "<CoE ", "<EoE/><FoE/><CoE ");
    const auto coe = other.find("<CoE "), coe_end = other.find("/>", coe) + 2;
    CHECK(missing(other.substr(0, coe) + other.substr(coe_end), esi::demand::schema).empty());
    CHECK(missing(other.substr(0, coe) + other.substr(coe_end), esi::demand::standard).empty());
}

TEST_CASE("all devices of a file are checked") {
    const auto xml = sample_esi();
    const auto at = xml.find("<Device "), end = xml.find("</Devices>");
    const auto two =
        replaced(xml, "</Devices>", replaced(xml.substr(at, end - at), " Physics=\"YY\"", "") + "</Devices>");
    const auto found = problem(two, "Descriptions/Devices/Device/@Physics");
    CHECK(found.starts_with("line "));
    CHECK(found.ends_with("<Device>: has no attribute Physics"));
    CHECK(problem(two, "types, sizes and references agree") == "");
}

TEST_CASE("the order of elements depends on their place") {
    const std::string rule = "elements stand in the schema's order";
    const auto xml = sample_esi();
    // An Info of a device, a Mailbox in it and a Properties below a vendor's own element are other elements than those
    // of an object.
    CHECK(problem(
              replaced(
                  xml, "<GroupType>",
                  "<Info><Mailbox><Timeout><ResponseTimeout>9</ResponseTimeout></Timeout></Mailbox></Info><GroupType>"),
              rule) == "");
    CHECK(
        problem(replaced(xml, "</Vendor>", "<VendorSpecific><Device><Name/><Type/></Device></VendorSpecific></Vendor>"),
                rule) == "");
    CHECK(problem(replaced(xml, "</Devices>", "</Devices><Modules><Module><Name>m</Name><Type/></Module></Modules>"),
                  rule)
              .ends_with("<Type>: stands too late in <Module>, expected the order Type Name RxPdo TxPdo Mailbox "
                         "DcSettingsMandatory Profile Comment ImageFile16x14 ImageData16x14 VendorSpecific"));
}

TEST_CASE("a device with process data alone needs no mailbox") {
    auto slave = test::sample_slave;
    slave.mailbox_out_size = slave.mailbox_in_size = 0;
    static constexpr std::array inputs{ethercat::pdo_entry{0x6000, 1, 8, ethercat::data_types::unsigned8, "level"}};
    slave.inputs = inputs;
    const auto xml = esi::write_esi(esi::make_device(slave, test::sample_texts, {}, false));
    const auto findings = esi::check_esi_text(xml, "sample.xml");
    REQUIRE(findings);
    for (const auto& each : *findings) {
        INFO(each.what << ": " << each.problem);
        CHECK(each.met());
    }
    CHECK(xml.find("<Mailbox") == xml.npos);
    const auto with_dictionary = replaced(xml, "</GroupType>", "</GroupType><Profile><Dictionary/></Profile>");
    CHECK(problem(with_dictionary, "Descriptions/Devices/Device/Mailbox").ends_with("<Device>: has no <Mailbox>"));
}

TEST_CASE("the mailbox must be the first two SyncManagers") {
    const std::string rule = "SyncManagers 0 and 1 are the mailbox";
    const auto xml = sample_esi();
    CHECK(problem(xml, rule) == "");
    CHECK(problem(replaced(xml, ">MBoxOut<", ">Outputs<"), rule).ends_with("expected the first <Sm> to be MBoxOut"));
    CHECK(problem(replaced(xml, ">MBoxIn<", ">MBoxOut<"), rule).ends_with("expected the second <Sm> to be MBoxIn"));
    CHECK(problem(replaced(xml, "DefaultSize=\"256\"", "DefaultSize=\"23\""), rule)
              .ends_with("a mailbox has 24 to 1486 bytes"));
    CHECK(problem(replaced(xml, "DefaultSize=\"256\"", "DefaultSize=\"24\""), rule) == "");
}

TEST_CASE("memory and mandatory objects are checked") {
    const auto xml = sample_esi();
    CHECK(problem(replaced(xml, "<ByteSize>512<", "<ByteSize>127<"), "ByteSize holds the SII's fixed part")
              .ends_with("expected 128 or more in <ByteSize>"));
    CHECK(problem(replaced(xml, "<ConfigData>80", "<ConfigData>"), "ConfigData has the SII's words 0 to 6")
              .ends_with("expected 14 bytes or more in <ConfigData>"));
    CHECK(problem(replaced(xml, "<Index>#x1000<", "<Index>#x1001<"), "object #x1000, device type")
              .ends_with("has no object #x1000"));
    CHECK(problem(replaced(xml, "<Index>#x1018<", "<Index>4121<"), "object #x1018, identity") != "");
    CHECK(problem(replaced(xml, "<Index>#x1018<", "<Index>4120<"), "object #x1018, identity") == "");
}

TEST_CASE("misplaced elements and elements unknown to the schema are reported") {
    const std::string rule = "elements stand in the schema's order";
    const auto xml = sample_esi();
    pugi::xml_document document;
    REQUIRE(document.load_string(xml.c_str()));
    auto device = document.select_node("//Device").node();
    device.append_move(device.child("GroupType"));
    CHECK(problem(text_of(document), rule)
              .find("<GroupType>: stands too late in <Device>, expected the order Sci Type") != std::string::npos);
    device.remove_child("GroupType");
    device.append_child("Colour");
    CHECK(problem(text_of(document), rule).ends_with("<Colour>: not known in <Device>"));
    CHECK(problem(replaced(xml, "<Vendor>", "<!-- a comment --><Vendor>"), rule) == "");
}

TEST_CASE("contradictory types and sizes are reported") {
    const std::string rule = "types, sizes and references agree";
    const auto xml = sample_esi();
    CHECK(problem(xml, rule) == "");
    CHECK(problem(replaced(xml, "<Type>DT1018</Type>", "<Type>DT1019</Type>"), rule).find("DT1019") !=
          std::string::npos);
}

TEST_CASE("text that is not an ESI document is an error") {
    CHECK(esi::check_esi_text("<EtherCATInfo>", "a.xml").error().code == esi::errc::not_xml);
    CHECK(esi::check_esi_text("<EtherCATConfig/>", "a.xml").error().code == esi::errc::not_esi);
    CHECK(esi::check_esi("/no/such/file.xml").error().code == esi::errc::unreadable);
}
