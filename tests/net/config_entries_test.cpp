// JausConfig.xml beyond addresses: several addresses, multicast, limits, nodes and components.
#include "net/config_text.hpp"
#include "support/paths.hpp"
#include <jauscat/net/config/access_list.hpp>

#include <chrono>
#include <filesystem>

using namespace jauscat;
using namespace net_test;

namespace {

/// The system b with these lines in it, beside system a.
net::system_entry system_b(const std::string& lines, const std::string& jausip = "2.0.0.0") {
    const auto config = parse("<thissystem>a</thissystem>" + system_a + "<system name='b' jausip='" + jausip +
                              "' ip='10.0.0.2' port='3794'>\n" + lines + "</system>\n");
    return *config.find("b");
}

/// What is said about that system, which begins in line 3 and has `lines` from line 4.
std::string complaint_in_b(const std::string& lines, const std::string& jausip = "2.0.0.0",
                           const std::string& ip = "10.0.0.2") {
    return complaint_about("<system name='b' jausip='" + jausip + "' ip='" + ip + "' port='3794'>\n" + lines +
                           "\n</system>");
}

const auto ip = [](const char* text) { return boost::asio::ip::make_address(text); };

} // namespace

TEST_CASE("options that a system omits have defaults") {
    const auto b = system_b("");
    CHECK(b.more_ips.empty());
    CHECK_FALSE(b.any_source_port);
    CHECK_FALSE(b.multicast);
    CHECK(b.limits.messages == net::rate{50'000, 5'000});
    CHECK(b.limits.large_data_memory == 1'048'576);
    CHECK(b.nodes.empty());
    CHECK(b.components.empty());
}

TEST_CASE("a system may have several addresses and send from any port") {
    const auto b = system_b("<ip>10.0.1.2</ip><ip>fd00::2</ip><sourceport>any</sourceport>");
    CHECK(b.ip == ip("10.0.0.2"));
    CHECK(b.more_ips == std::vector{ip("10.0.1.2"), ip("fd00::2")});
    CHECK(b.any_source_port);
    CHECK_FALSE(system_b("<sourceport>same</sourceport>").any_source_port);

    CHECK(complaint_in_b("<sourceport>all</sourceport>") ==
          "test.xml:4: sourceport \"all\" is unknown; use same or any");
    CHECK(complaint_in_b("<ip>10.0.1.2</ip>\n<ip>10.0.0.2</ip>") ==
          "test.xml:5: ip 10.0.0.2 is given twice in <system>; keep one");
    CHECK(complaint_in_b("<ip>10.0.1.2</ip>\n<ip>10.0.1</ip>") ==
          "test.xml:5: ip \"10.0.1\" is not an IP address, such as 127.0.0.1");
    std::string many;
    for (int i = 1; i != 9; ++i) many += "<ip>10.0.1." + std::to_string(i) + "</ip>\n";
    CHECK(complaint_in_b(many) == "test.xml:11: a <system> has at most 8 <ip>");
}

TEST_CASE("a system says what its subsystem is") {
    using enum jaus::subsystem_type;
    CHECK(system_b("").type == other);
    CHECK(system_b("<type>vehicle</type>").type == vehicle);
    CHECK(system_b("<type>operator</type>").type == operator_control_unit);
    CHECK(system_b("<type>other</type>").type == other);
    CHECK(complaint_in_b("<type>boat</type>") ==
          "test.xml:4: type \"boat\" is unknown; use other, vehicle or operator");
}

TEST_CASE("a system takes part in a multicast group") {
    const auto standard = system_b("<multicast/>").multicast;
    REQUIRE(standard);
    CHECK(standard->group == ip("224.1.0.1"));
    CHECK(standard->port == 3794);
    CHECK(standard->ttl == 1);
    CHECK(standard->loop);
    CHECK(standard->interface_name.empty());

    const auto own = system_b("<multicast><group>239.1.2.3</group><port>5000</port><ttl>8</ttl>"
                              "<interface>eth0</interface><loop>no</loop></multicast>")
                         .multicast;
    REQUIRE(own);
    CHECK(own->group == ip("239.1.2.3"));
    CHECK(own->port == 5000);
    CHECK(own->ttl == 8);
    CHECK(own->interface_name == "eth0");
    CHECK_FALSE(own->loop);
    CHECK(complaint_in_b("<multicast group='ff15::1'/>", "2.0.0.0", "fd00::2") == "accepted");

    CHECK(complaint_in_b("<multicast group='10.0.0.1'/>") ==
          "test.xml:4: group \"10.0.0.1\" is no multicast group, such as 224.1.0.1");
    CHECK(complaint_in_b("<multicast>\n<group>all</group></multicast>") ==
          "test.xml:5: group \"all\" is not an IP address, such as 224.1.0.1");
    CHECK(complaint_in_b("<multicast/>", "2.0.0.0", "fd00::2") ==
          "test.xml:4: the group 224.1.0.1 and the ip fd00::2 are of different IP versions; give a group of the "
          "other, such as ff15::e001:1");
    CHECK(complaint_in_b("<multicast ttl='256'/>") == "test.xml:4: ttl \"256\" is not a number of hops, 0 to 255");
    CHECK(complaint_in_b("<multicast loop='1'/>") == "test.xml:4: loop \"1\" is unknown; use no or yes");
    CHECK(complaint_in_b("<multicast/>\n<multicast/>") ==
          "test.xml:5: \"multicast\" is given twice in <system>; keep one");
    CHECK(complaint_in_b("<multicast hops='1'/>") ==
          "test.xml:4: unknown \"hops\" in <multicast>; remove it or correct its name");
}

TEST_CASE("a system may have limits") {
    const auto limits =
        system_b("<limits><rate>200</rate><burst>20</burst><largedata>65536</largedata></limits>").limits;
    CHECK(limits.messages == net::rate{200, 20});
    CHECK(limits.large_data_memory == 65536);
    CHECK(system_b("<limits rate='0'/>").limits.messages.per_second == 0);

    CHECK(complaint_in_b("<limits rate='fast'/>") ==
          "test.xml:4: rate \"fast\" is not a number of messages each second "
          "(0: no limit), 0 to 1000000000");
    CHECK(complaint_in_b("<limits burst='0'/>") ==
          "test.xml:4: burst \"0\" is not a number of messages at once, 1 to 1000000000");
    CHECK(complaint_in_b("<limits>\n<largedata>1 MB</largedata></limits>") ==
          "test.xml:5: largedata \"1 MB\" is not a number of bytes, 0 to 1073741824");
}

TEST_CASE("a system may list nodes and components") {
    const auto b = system_b("<component><id>1</id><name>Node Manager</name><authority>255</authority></component>"
                            "<node id='4' name='arm'><component id='49' instance='2' name='Primitive Manipulator'/>"
                            "</node><component id='33'/>");
    REQUIRE(b.nodes.size() == 1);
    CHECK(b.nodes[0].id == 4);
    CHECK(b.nodes[0].name == "arm");
    REQUIRE(b.components.size() == 3);
    const auto& arm = b.components[0];
    CHECK(net::to_jausip(arm.id) == "2.4.49.2");
    CHECK(arm.name == "Primitive Manipulator");
    CHECK(arm.authority == 0);
    const auto& manager = b.components[1];
    CHECK(net::to_jausip(manager.id) == "2.1.1.1");
    CHECK(manager.name == "Node Manager");
    CHECK(manager.authority == 255);
    CHECK(net::to_jausip(b.components[2].id) == "2.1.33.1");
    CHECK(b.components[2].name.empty());
    CHECK(net::to_jausip(system_b("<component id='33'/>", "2.7.0.0").components.at(0).id) == "2.7.33.1");
}

TEST_CASE("invalid nodes and components are refused with their line") {
    CHECK(complaint_in_b("<component/>") == "test.xml:4: this <component> needs <id>");
    CHECK(complaint_in_b("<node><name>x</name></node>") == "test.xml:4: this <node> needs <id>");
    for (const auto* id : {"0", "255", "x"}) {
        CHECK(complaint_in_b("<component>\n<id>" + std::string{id} + "</id></component>") ==
              "test.xml:5: id \"" + std::string{id} + "\" is not a component's ID, 1 to 254");
        CHECK(complaint_in_b("<component id='1' instance='" + std::string{id} + "'/>") ==
              "test.xml:4: instance \"" + std::string{id} + "\" is not an instance's ID, 1 to 254");
        CHECK(complaint_in_b("<node id='" + std::string{id} + "'/>") ==
              "test.xml:4: id \"" + std::string{id} + "\" is not a node's ID, 1 to 254");
    }
    CHECK(complaint_in_b("<component id='1' authority='256'/>") ==
          "test.xml:4: authority \"256\" is not an authority code, 0 to 255");
    CHECK(complaint_in_b("<component id='1'/>\n<node id='1'>\n<component id='1'/></node>").starts_with("test.xml:4: "));
    CHECK(complaint_in_b("<component id='1'/>\n<component id='1'/>") ==
          "test.xml:5: the component 2.1.1.1 is taken by the <component> in line 4; give each its own id or instance");
    CHECK(complaint_in_b("<node id='2'/>\n<node id='2'/>") ==
          "test.xml:5: the node 2 is taken by the <node> in line 4; put all its components there");
    CHECK(complaint_in_b("<node id='2'/>", "2.1.0.0") ==
          "test.xml:4: the node 2 is outside of its system's jausip 2.1.0.0");
    CHECK(complaint_in_b("<component id='34'/>", "2.1.33.0") ==
          "test.xml:4: the component 2.1.34.1 is outside of its system's jausip 2.1.33.0");
    CHECK(complaint_in_b("<component id='34'/>", "0.0.0.0") ==
          "test.xml:4: a <system> with components needs a jausip that names its subsystem, such as 1.0.0.0");
    CHECK(complaint_about("<system name='b' jausip='2.0.0.0' ip='::1' port='1'><component id='1'/></system>\n"
                          "<system name='c' jausip='2.1.0.0' ip='::1' port='2'><component id='1'/></system>") ==
          "test.xml:4: the component 2.1.1.1 is taken by the <component> in line 3; give each its own id or instance");
}

TEST_CASE("a system may have a master, driven by its own program or by another system's") {
    const auto own = system_b("<ethercat interface='eth0'/>", "2.2.0.0").ethercat;
    REQUIRE(own);
    CHECK(own->controller == "b");
    CHECK(own->interface_name == "eth0");
    CHECK(own->udp_host.empty());
    CHECK(own->line == 4);
    const auto others = system_b("<ethercat><controller>a</controller><interface>udp:fd00::7:34980</interface>"
                                 "</ethercat>",
                                 "2.2.34.0")
                            .ethercat;
    REQUIRE(others);
    CHECK(others->controller == "a");
    CHECK(others->interface_name.empty());
    CHECK(others->udp_host == "fd00::7");
    CHECK(others->udp_port == 34980);
    CHECK_FALSE(system_b("").ethercat);
}

TEST_CASE("a controller has the masters whose entries name it, in file order") {
    const auto config = parse("<thissystem>a</thissystem>" + system_a +
                              "<system name='b' jausip='2.2.0.0' ip='::1' port='1'><ethercat interface='x'/></system>"
                              "<system name='c' jausip='2.3.0.0' ip='::1' port='2'>"
                              "<ethercat interface='y' controller='b'/></system>"
                              "<system name='d' jausip='3.2.0.0' ip='::2' port='1'><ethercat interface='x'/></system>");
    REQUIRE(config.masters_of("b").size() == 2);
    CHECK(config.masters_of("b")[0]->name == "b");
    CHECK(config.masters_of("b")[1]->name == "c");
    CHECK(config.masters_of("d").size() == 1);
    CHECK(config.masters_of("a").empty());
}

TEST_CASE("invalid masters are refused with their line") {
    const std::string node = "2.2.0.0";
    CHECK(complaint_in_b("<ethercat interface='eth0'/>", node) == "accepted");
    CHECK(complaint_in_b("<ethercat/>", node) == "test.xml:4: this <ethercat> needs <interface>");
    CHECK(complaint_in_b("<ethercat interface='eth0'/>") ==
          "test.xml:4: the jausip 2.0.0.0 of a <system> with <ethercat> must name its node, such as 2.2.0.0: the slave "
          "has its number as station address");
    CHECK(complaint_in_b("<ethercat interface='eth0' controller='c'/>", node) ==
          "test.xml:4: there is no system \"c\"; the file has: a, b");
    for (const auto* name : {"a/b", "sixteen-letters-", "eth0:1", "udp:", "udp:34980", "udp::34980", "e 0"})
        CHECK(complaint_in_b("<ethercat>\n<interface>" + std::string{name} + "</interface></ethercat>", node) ==
              "test.xml:5: interface \"" + std::string{name} +
                  "\" is neither a network interface, such as eth0, nor udp:HOST:PORT");
    for (const auto* port : {"", "0", "65536", "x"})
        CHECK(complaint_in_b("<ethercat interface='udp:arm:" + std::string{port} + "'/>", node) ==
              "test.xml:4: port of the interface \"" + std::string{port} + "\" is not a UDP port, 1 to 65535");
    CHECK(complaint_in_b("<ethercat interface='eth0'/>\n<ethercat interface='eth1'/>", node) ==
          "test.xml:5: \"ethercat\" is given twice in <system>; keep one");
    CHECK(complaint_in_b("<ethercat interface='eth0' station='2'/>", node) ==
          "test.xml:4: unknown \"station\" in <ethercat>; remove it or correct its name");
    CHECK(complaint_about("<system name='b' jausip='2.2.0.0' ip='::1' port='1'><ethercat interface='x'/></system>\n"
                          "<system name='c' jausip='2.3.0.0' ip='::1' port='2'>\n"
                          "<ethercat interface='x' controller='b'/></system>") ==
          "test.xml:5: the interface is that of the <ethercat> in line 3; give each master its own");
}

TEST_CASE("a master may name its slaves, what identifies them, and the objects to write at their start") {
    const auto b = system_b("<ethercat interface='eth0'><slave name='shoulder' position='0' vendor='0x2' product='2' "
                            "revision='3' esi='drive.xml'><sdo index='0x6060' type='SINT' value='-1'/>"
                            "<sdo index='24722' subindex='1' type='UINT' value='0x102'/></slave>"
                            "<slave name='tool' alias='17' identification='0x12' serial='7' optional='yes'/>"
                            "</ethercat><component id='56' slaves=' shoulder  tool'/><component id='33'/>",
                            "2.2.0.0");
    REQUIRE(b.ethercat->slaves.size() == 2);
    const auto& shoulder = b.ethercat->slaves[0];
    CHECK(shoulder.name == "shoulder");
    CHECK(shoulder.position == 0);
    CHECK_FALSE(shoulder.alias);
    CHECK(shoulder.vendor == 2U);
    CHECK(shoulder.product == 2U);
    CHECK(shoulder.revision == 3U);
    CHECK_FALSE(shoulder.serial);
    CHECK(shoulder.esi == "drive.xml");
    CHECK_FALSE(shoulder.is_optional);
    REQUIRE(shoulder.start_up.size() == 2);
    CHECK(shoulder.start_up[0].index == 0x6060);
    CHECK(shoulder.start_up[0].subindex == 0);
    CHECK(shoulder.start_up[0].data == std::vector{std::byte{0xFF}});
    CHECK(shoulder.start_up[1].index == 0x6092);
    CHECK(shoulder.start_up[1].subindex == 1);
    CHECK(shoulder.start_up[1].data == std::vector{std::byte{0x02}, std::byte{0x01}});
    const auto* const tool = b.ethercat->find("tool");
    REQUIRE(tool != nullptr);
    CHECK(tool->alias == 17);
    CHECK(tool->identification == 0x12);
    CHECK(tool->serial == 7U);
    CHECK(tool->is_optional);
    CHECK(b.ethercat->find("elbow") == nullptr);
    CHECK(b.components.at(0).slaves == std::vector<std::string>{"shoulder", "tool"});
    CHECK(b.components.at(1).slaves.empty());
}

TEST_CASE("a slave may have SYNC signals, by numbers or by a mode of its ESI file") {
    const auto slave = [](const std::string& inner) {
        const auto b = system_b("<ethercat interface='eth0'><slave name='x' position='0' esi='x.xml'>" + inner +
                                    "</slave></ethercat>",
                                "2.2.0.0");
        return b.ethercat->slaves.at(0);
    };
    using jauscat::net::sync_entry;
    CHECK_FALSE(slave("").sync);
    CHECK(slave("<sync/>").sync == sync_entry{.assign_activate = 0x0300});
    CHECK(slave("<sync assign_activate='0x700' cycle='500000' sync1_delay='1000' shift='-250000'/>").sync ==
          sync_entry{.assign_activate = 0x0700, .cycle = 500'000, .sync1_delay = 1'000, .shift = -250'000});
    CHECK(slave("<sync mode='DC'/>").sync_mode == "DC");
    CHECK_FALSE(slave("<sync mode='DC'/>").sync);
}

TEST_CASE("a slave may have timeouts of its own") {
    const auto slave = [](const std::string& inner) {
        const auto b = system_b(
            "<ethercat interface='eth0'><slave name='x' position='0'>" + inner + "</slave></ethercat>", "2.2.0.0");
        return b.ethercat->slaves.at(0).timeouts;
    };
    using jauscat::net::timeout_entry;
    using milliseconds = timeout_entry::milliseconds;
    CHECK(slave("") == timeout_entry{});
    CHECK(slave("<timeouts mailbox='2100'/>") == timeout_entry{.mailbox = milliseconds{2100}});
    CHECK(slave("<timeouts pre_op='3000' safe_op_op='0xFFFF' back_to_init='1' back_to_safe_op='200'/>") ==
          timeout_entry{milliseconds{3000}, milliseconds{65535}, milliseconds{1}, milliseconds{200}, {}});
}

TEST_CASE("the values of objects are given by the type") {
    const auto bytes_of = [](const std::string& type, const std::string& value) {
        const auto b = system_b("<ethercat interface='eth0'><slave name='x' position='0'><sdo index='1' type='" + type +
                                    "' value='" + value + "'/></slave></ethercat>",
                                "2.2.0.0");
        std::string hex;
        for (const auto each : b.ethercat->slaves.at(0).start_up.at(0).data) {
            constexpr std::string_view digits = "0123456789abcdef";
            hex += digits[std::to_integer<std::size_t>(each) / 16];
            hex += digits[std::to_integer<std::size_t>(each) % 16];
        }
        return hex;
    };
    CHECK(bytes_of("BOOL", "1") == "01");
    CHECK(bytes_of("SINT", "-128") == "80");
    CHECK(bytes_of("INT", "-2") == "feff");
    CHECK(bytes_of("DINT", "-2147483648") == "00000080");
    CHECK(bytes_of("LINT", "1") == "0100000000000000");
    CHECK(bytes_of("USINT", "0xFF") == "ff");
    CHECK(bytes_of("UINT", "65535") == "ffff");
    CHECK(bytes_of("UDINT", "0x01020304") == "04030201");
    CHECK(bytes_of("ULINT", "0x0102030405060708") == "0807060504030201");
    CHECK(bytes_of("REAL", "1.5") == "0000c03f");
    CHECK(bytes_of("LREAL", "-2") == "00000000000000c0");
    CHECK(bytes_of("STRING", "ab") == "6162");
    CHECK(bytes_of("OCTET_STRING", "00fF7a") == "00ff7a");
}

TEST_CASE("invalid slaves are refused with their line") {
    const auto in_ethercat = [](const std::string& lines) {
        return complaint_in_b("<ethercat interface='eth0'>\n" + lines + "</ethercat>", "2.2.0.0");
    };
    const auto object = [&](const std::string& attributes) {
        return in_ethercat("<slave name='x' position='0'>\n<sdo " + attributes + "/></slave>");
    };
    CHECK(in_ethercat("<slave name='x' position='0'/>") == "accepted");
    CHECK(in_ethercat("<slave position='0'/>") == "test.xml:5: this <slave> needs <name>");
    CHECK(in_ethercat("<slave name='x y' position='0'/>") ==
          "test.xml:5: the name \"x y\" of a slave has no blanks; write it as one word");
    CHECK(in_ethercat("<slave name='x'/>") ==
          "test.xml:5: nothing identifies the slave \"x\"; give its position, alias, identification, vendor, product, "
          "serial or esi");
    CHECK(in_ethercat("<slave name='x' alias='0'/>") ==
          "test.xml:5: alias \"0\" is not a station alias, 1 to 65535, decimal or hexadecimal (0x10)");
    CHECK(in_ethercat("<slave name='x' vendor='0x100000000'/>") ==
          "test.xml:5: vendor \"0x100000000\" is not a vendor ID, 0 to 4294967295, decimal or hexadecimal (0x10)");
    CHECK(in_ethercat("<slave name='x' position='0'/>\n<slave name='x' position='1'/>") ==
          "test.xml:6: the slave \"x\" has the name of the <slave> in line 5; give each its own");
    CHECK(in_ethercat("<slave name='x' position='0'/>\n<slave name='y' position='0'/>") ==
          "test.xml:6: the slave \"y\" has the position of the <slave> in line 5; give each its own");
    CHECK(in_ethercat("<slave name='x' alias='1'/>\n<slave name='y' alias='1'/>") ==
          "test.xml:6: the slave \"y\" has the alias of the <slave> in line 5; give each its own");
    const auto sync = [&](const std::string& inner, const std::string& more = "") {
        return in_ethercat("<slave name='x' position='0' " + more + ">\n" + inner + "</slave>");
    };
    CHECK(sync("<sync/>") == "accepted");
    CHECK(sync("<sync mode='DC'/>") == "test.xml:6: the mode \"DC\" is one of an ESI file; give the slave's esi");
    CHECK(sync("<sync mode='DC' cycle='1'/>", "esi='x.xml'") ==
          "test.xml:6: a <sync> has a mode or numbers; leave one of the two out");
    CHECK(sync("<sync cycle='0'/>") ==
          "test.xml:6: cycle \"0\" is not a cycle in ns, 1 to 4294967295, decimal or hexadecimal (0x10)");
    CHECK(sync("<sync shift='1 ms'/>") == "test.xml:6: shift \"1 ms\" is not in ns, -1000000000 to 1000000000");
    CHECK(sync("<timeouts mailbox='0'/>") ==
          "test.xml:6: mailbox \"0\" is not a time in ms, 1 to 65535, decimal or hexadecimal (0x10)");
    CHECK(sync("<timeouts mailbox='1'/>\n<timeouts/>") == "test.xml:7: the slave \"x\" has two <timeouts>; leave one");
    CHECK(sync("<sync/>\n<sync/>") == "test.xml:7: the slave \"x\" has two <sync>; leave one");
    CHECK(object("index='0x6060' type='SINT' value='9'") == "accepted");
    CHECK(object("type='SINT' value='9'") == "test.xml:6: this <sdo> needs <index>");
    CHECK(object("index='0' type='SINT' value='9'") ==
          "test.xml:6: index \"0\" is not an object's index, 1 to 65535, decimal or hexadecimal (0x10)");
    CHECK(object("index='0x6060' type='SINT' value='128'") ==
          "test.xml:6: value \"128\" is not of the type SINT, -128 to 127, decimal or hexadecimal (0x10)");
    CHECK(object("index='0x6060' type='BOOL' value='2'") == "test.xml:6: value \"2\" is not a BOOL, 0 or 1");
    CHECK(object("index='0x6060' type='REAL' value='x'") == "test.xml:6: value \"x\" is not a number of the type REAL");
    CHECK(object("index='0x6060' type='OCTET_STRING' value='012'") ==
          "test.xml:6: value \"012\" is not pairs of hexadecimal digits");
    CHECK(object("index='0x6060' type='short' value='1'") ==
          "test.xml:6: type \"short\" is unknown; use BOOL, SINT, INT, DINT, LINT, USINT, UINT, UDINT, ULINT, REAL, "
          "LREAL, STRING or OCTET_STRING");
    CHECK(object("index='0x6060' type='SINT' value='1' transition='IP'") != "accepted");
    const auto behind = [](const std::string& slaves) {
        return complaint_in_b("<ethercat interface='eth0'><slave name='x' position='0'/></ethercat>\n"
                              "<component id='33' slaves='" +
                                  slaves + "'/>",
                              "2.2.0.0");
    };
    CHECK(behind("x") == "accepted");
    CHECK(behind("y") == "test.xml:5: there is no <slave> \"y\" in the <ethercat> of this <system>");
    CHECK(behind("x x") == "test.xml:5: the slave \"x\" is given twice; keep one");
    CHECK(behind("") == "test.xml:5: slaves names no <slave>; name one, or remove it");
}

TEST_CASE("the root element may name its schema") {
    CHECK(complaint("<jausconfig xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
                    "xsi:noNamespaceSchemaLocation='JausConfig.xsd' thissystem='a'>" +
                    system_a + "</jausconfig>") == "accepted");
    CHECK(complaint_in_b("<limits xmlns:x='y'/>") ==
          "test.xml:4: unknown \"xmlns:x\" in <limits>; remove it or correct its name");
}

TEST_CASE("a system may speak SAE JAUS beside the RA, or alone") {
    const auto both = system_b("<sae id='126.1.0'><judp/><jtcp listen='3795' connect='c'/></sae></system>\n"
                               "<system name='c' ip='10.0.0.3'><sae id='126.2.10'><jtcp listen='3794'/></sae>");
    CHECK(both.has_ra);
    REQUIRE(both.sae);
    CHECK(both.sae->id == sae::jaus_id{0, 1, 126});
    REQUIRE(both.sae->judp);
    CHECK_FALSE(both.sae->judp->group);
    REQUIRE(both.sae->jtcp);
    CHECK(both.sae->jtcp->listen == 3795);
    CHECK(both.sae->jtcp->connect == std::vector<std::string>{"c"});
    CHECK_FALSE(both.sae->jserial);

    const auto alone = parse("<thissystem>a</thissystem>" + system_a +
                             "<system name='b'><sae id='126.0.0'><jserial device='/dev/ttyS0'/></sae></system>\n"
                             "<system name='c' ip='10.0.0.3' port='3794'><sae id='126.1.0'><judp><multicast/></judp>"
                             "</sae></system>\n"
                             "<system name='d' ip='10.0.0.4' port='3794'><sae id='126.1.10'><judp/></sae></system>\n");
    const auto& b = *alone.find("b");
    CHECK_FALSE(b.has_ra);
    REQUIRE(b.sae->jserial);
    CHECK(b.sae->jserial->device == "/dev/ttyS0");
    CHECK(b.sae->jserial->baud == 115'200);
    CHECK(alone.find("c")->sae->judp->group == net::judp_multicast());
    const auto name_of = [&](sae::jaus_id id) { return alone.system_of(id) ? alone.system_of(id)->name : "none"; };
    CHECK(name_of({10, 1, 126}) == "d");
    CHECK(name_of({11, 1, 126}) == "c");
    CHECK(name_of({10, 2, 126}) == "b");
    CHECK(name_of({10, 1, 127}) == "none");
    CHECK(alone.next_hop({1, 10, 1, 126}) == nullptr); // the RA does not see them
    REQUIRE(alone.next_hop({1, 10, 1, 1}) != nullptr);
    const net::access_list list{alone};
    CHECK(list.is_open()); // as if a were the only system
}

TEST_CASE("mistakes in <sae> are told in one run, by line") {
    const auto sae_in_b = [](const std::string& lines) {
        return complaint_in_b("<sae id='126.1.10'>\n" + lines + "</sae>");
    };
    CHECK(complaint("<jausconfig thissystem='a'>\n" + system_a +
                    "<system name='b' ip='10.0.0.2'>\n"
                    "<multicast/>\n"
                    "<sae id='126.0.10'>\n"
                    "<judp speed='1'/>\n"
                    "<jtcp listen='x'/>\n"
                    "<jserial baud='0'/>\n"
                    "</sae></system>\n"
                    "<system name='c' jausip='3.0.0.0' ip='::1' port='3794'><sae id='1.1.1'>\n"
                    "<judp/></sae><component id='1'/></system>\n"
                    "<system name='d'><sae id='2.1.1'/>\n"
                    "<component id='1'/></system></jausconfig>") ==
          "test.xml:4: <multicast> of a <system> without jausip has no use; put it into <judp>, or give a jausip\n"
          "test.xml:5: id \"126.0.10\" is not subsystem.node.component, such as 126.1.10, or 126.1.0 or 126.0.0 for all"
          " of that level: subsystem 1 to 65534, the others to 254\n"
          "test.xml:6: <judp> needs <port> in its <system>\n"
          "test.xml:6: unknown \"speed\" in <judp>; remove it or correct its name\n"
          "test.xml:7: listen \"x\" is not a TCP port, 1 to 65535\n"
          "test.xml:8: this <jserial> needs <device>\n"
          "test.xml:8: baud \"0\" is not a number of bits each second, 50 to 4000000\n"
          "test.xml:10: <judp> needs an IPv4 address, and the ip ::1 is of IPv6\n"
          "test.xml:12: <sae> has no medium; give <judp/>, <jtcp> or <jserial>\n"
          "test.xml:13: <component> of a <system> without jausip has no use; give a jausip");
    for (const auto* id : {"126.1", "126.1.255", "126.255.0", "65535.1.1", "0.1.1", "0.0.0", "a.1.1", ""})
        CHECK(complaint_in_b("<sae id='" + std::string{id} + "'><judp/></sae>") != "accepted");
    CHECK(sae_in_b("<jtcp/>") ==
          "test.xml:5: <jtcp> has no use; give listen, the port at which it accepts connections, or"
          " connect, the names of systems");
    CHECK(sae_in_b("<jtcp connect='c'/>") == "test.xml:4: there is no system \"c\"; the file has: a, b");
    CHECK(sae_in_b("<jtcp connect='b'/>") == "test.xml:4: the system \"b\" connects to itself; remove it from connect");
    CHECK(sae_in_b("<jtcp connect='a'/>") ==
          "test.xml:4: the system \"a\" accepts no connections; give it <sae> with <jtcp listen=...>");
    CHECK(sae_in_b("<jtcp connect='a a'/>") == "test.xml:5: the system \"a\" is given twice in connect; keep one");
    CHECK(sae_in_b("<judp/><judp/>") == "test.xml:5: \"judp\" is given twice in <sae>; keep one");
    CHECK(sae_in_b("<judp><multicast group='10.0.0.1'/></judp>") ==
          "test.xml:5: group \"10.0.0.1\" is no multicast group, such as 239.255.0.1");
    CHECK(complaint_in_b("<sae id='126.1.10'><judp/></sae></system>\n"
                         "<system name='c' ip='10.0.0.3' port='1'><sae id='126.1.10'><judp/></sae>") ==
          "test.xml:5: the id 126.1.10 is taken by the <sae> in line 4; give each its own");
}

// The same files are given to the schema by schema.sh.
TEST_CASE("files are accepted and refused as by the schema") {
    const std::filesystem::path folder{support::source_file("tests/net/config")};
    std::size_t good = 0, broken = 0;
    for (const auto& file : std::filesystem::directory_iterator{folder / "good"}) {
        CHECK_NOTHROW(net::read_jaus_config(file.path()));
        ++good;
    }
    for (const auto& file : std::filesystem::directory_iterator{folder / "broken"}) {
        INFO(file.path());
        CHECK_THROWS_AS(net::read_jaus_config(file.path()), net::config_error);
        ++broken;
    }
    CHECK(good >= 2);
    CHECK(broken >= 30);
}

TEST_CASE("a file with every option is read completely") {
    const auto config = net::read_jaus_config(support::source_file("tests/net/config/good/everything.xml"));
    CHECK(config.me().limits.large_data_memory == 8'388'608);
    CHECK(config.me().components.size() == 4);
    CHECK(config.me().multicast->interface_name == "eth0");
    REQUIRE(config.find("ocu") != nullptr);
    CHECK(config.find("ocu")->more_ips.size() == 1);
    CHECK(config.find("ocu")->any_source_port);
    CHECK(config.find("ocu")->limits.messages == net::rate{2000, 200});
    CHECK(config.masters_of("arm").size() == 2);
    CHECK(config.find("arm")->ethercat->slaves.size() == 3);
    CHECK(config.find("arm")->components.at(0).slaves.size() == 2);
    const auto& media = *config.find("payload")->sae;
    CHECK(media.judp->group->interface_name == "eth0");
    CHECK_FALSE(media.judp->group->loop);
    CHECK(media.jtcp->connect == std::vector<std::string>{"station"});
    CHECK(media.jserial->baud == 57600);
    CHECK(config.find("station")->sae->jtcp->listen == 3795);
}

TEST_CASE("a file with 250 subsystems of 254 nodes is read quickly, with the lines of all") {
    std::string text = "<jausconfig>\n<thissystem>s1</thissystem>\n";
    for (int id = 1; id <= 250; ++id) {
        const auto number = std::to_string(id);
        text += "<system name=\"s" + number + "\" jausip=\"" + number + ".0.0.0\" ip=\"127.0.0.1\" port=\"3794\">\n";
        for (int node = 1; node <= 254; ++node)
            text += "<node id=\"" + std::to_string(node) + "\"><component id=\"33\"/></node>\n";
        text += "</system>\n";
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto config = net::parse_jaus_config(text + "</jausconfig>", "large");
    REQUIRE(std::chrono::steady_clock::now() - begin <
            std::chrono::seconds{30}); // minutes, if time grew with its square
    REQUIRE(config.systems.size() == 250);
    const auto& last = config.systems.back();
    REQUIRE(last.line == 3 + 249 * 256);
    REQUIRE(last.components.size() == 254);
    REQUIRE(last.components.back().id == jauscat::jaus::address{1, 33, 254, 250});
    REQUIRE(last.components.back().line == last.line + 254);
}
