// JausConfig.xml: valid files, and the error for each kind of invalid one.
#include "net/config_text.hpp"
#include "support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

using namespace jauscat;
using namespace jauscat::net;
using namespace net_test;

namespace {

std::string hop(const jaus_config& config, std::string_view destination) {
    const auto* entry = config.next_hop(parse_jausip(destination).value());
    return entry ? entry->name : "none";
}

} // namespace

TEST_CASE("the example file names systems a, b and c") {
    const auto config = read_jaus_config(support::source_file("examples/JausConfig.xml"));
    REQUIRE(config.systems.size() == 3);
    CHECK(config.this_system == "a");
    CHECK(config.me().name == "a");
    CHECK(config.me().jausip == jaus::address{0, 0, 0, 1});
    CHECK(config.me().endpoint() == boost::asio::ip::udp::endpoint{boost::asio::ip::make_address("127.0.0.1"), 39777});
    CHECK(config.me().framing == jaus::framing::bare);
    REQUIRE(config.find("b") != nullptr);
    CHECK(config.find("b")->jausip == jaus::address{0, 0, 0, 2});
    CHECK(config.find("b")->port == 39778);
    REQUIRE(config.find("c") != nullptr);
    CHECK(config.find("c")->jausip == jaus::address{0, 0, 0, 3});
    CHECK(config.find("c")->port == 39779);
    CHECK(config.find("d") == nullptr);
}

TEST_CASE("attributes, any case of the root, spaces, comments, a byte order mark and a framing are accepted") {
    const auto config =
        parse_jaus_config("\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!-- c -->\n<JausConfig thissystem='arm'>\n"
                          "<system name='arm' jausip='3.1.33.1' ip='::1' port='1' framing='JAUS01.0'/>\n"
                          "<system name='b'><jausip> 2.0.0.0\n</jausip><!-- c --><ip>10.0.0.1</ip>"
                          "<port> 65535 </port><framing>bare</framing></system></JausConfig>",
                          "x");
    CHECK(config.me().jausip == jaus::address{1, 33, 1, 3});
    CHECK(config.me().ip.is_v6());
    CHECK(config.me().framing == jaus::framing::jaus01);
    CHECK(config.me().line == 4);
    CHECK(config.find("b")->port == 65535);
    CHECK(config.find("b")->framing == jaus::framing::bare);
    CHECK(config.find("b")->jausip.subsystem == 2);
}

TEST_CASE("one file configures every system") {
    const auto config = parse("<thissystem>a</thissystem>\n" + system_a +
                              "<system name='b' jausip='2.0.0.0' ip='127.0.0.1' port='39778'/>\n");
    CHECK(config.with_this("b").me().port == 39778);
    CHECK(config.me().port == 39777);
    try {
        static_cast<void>(config.with_this("c"));
        FAIL("a system that is not there was accepted");
    } catch (const config_error& error) {
        CHECK(std::string{error.what()} == "test.xml: there is no system \"c\"; the file has: a, b");
        CHECK(error.code() == net::config_errc::no_such_system);
    }
}

TEST_CASE("a message is sent to the system with the most specific jausip") {
    const auto system = [](const std::string& name, const std::string& jausip) {
        return "<system name='" + name + "' jausip='" + jausip + "' ip='127.0.0.1' port='1'/>";
    };
    const auto config = parse("<thissystem>one</thissystem>" + system("one", "1.0.0.0") + system("pd", "1.2.33.0") +
                              system("node", "1.2.0.0") + system("exact", "1.2.33.4") + system("any-pd", "0.0.33.0"));
    CHECK(hop(config, "1.1.1.1") == "one");
    CHECK(hop(config, "1.2.1.1") == "node");
    CHECK(hop(config, "1.2.33.1") == "pd");
    CHECK(hop(config, "1.2.33.4") == "exact");
    CHECK(hop(config, "1.3.33.4") == "one");
    CHECK(hop(config, "9.3.33.4") == "any-pd");
    CHECK(hop(config, "9.3.34.4") == "none");
    CHECK(hop(config, "255.255.1.1") == "none");
}

TEST_CASE("a jausip is four numbers from the subsystem to the instance") {
    CHECK(parse_jausip("1.2.3.4") == jaus::address{4, 3, 2, 1});
    CHECK(to_jausip(jaus::address{4, 3, 2, 255}) == "255.2.3.4");
    for (const auto* bad : {"", "1", "1.2.3", "1.2.3.", "1.2.3.4.", "1.2.3.4.5", "1.2.3.256", "1..3.4", "-1.2.3.4",
                            "a.b.c.d", " 1.2.3.4", "1,2,3,4", "+1.2.3.4"})
        CHECK_FALSE(parse_jausip(bad));
}

TEST_CASE("a file that cannot be read is named, with the reason") {
    try {
        static_cast<void>(read_jaus_config("/nonexistent/JausConfig.xml"));
        FAIL("a missing file was accepted");
    } catch (const config_error& error) {
        CHECK(std::string{error.what()}.starts_with("/nonexistent/JausConfig.xml: cannot be read: No such file"));
        CHECK(std::string{error.what()}.find("; give the path") != std::string::npos);
        CHECK(error.line() == 0);
        CHECK(error.code() == net::config_errc::unreadable);
    }
    try {
        static_cast<void>(read_jaus_config("/"));
        FAIL("a directory was accepted");
    } catch (const config_error& error) {
        CHECK(std::string{error.what()}.starts_with("/: cannot be read: Is a directory"));
    }
}

TEST_CASE("errors of a file have its path") {
    const auto path =
        std::filesystem::temp_directory_path() / ("jauscat-config-" + std::to_string(::getpid()) + ".xml");
    std::ofstream{path} << "<jausconfig>\n</jausconfig>";
    CHECK_THROWS_AS(read_jaus_config(path), config_error);
    try {
        static_cast<void>(read_jaus_config(path));
    } catch (const config_error& error) {
        CHECK(std::string{error.what()}.starts_with(path.string() + ":1: no <system>"));
    }
    std::filesystem::remove(path);
}

TEST_CASE("each error of a configuration has a code, and the name and line concerned") {
    using net::config_errc;
    struct row {
        std::string text;
        config_errc code;
        std::string_view name;
        std::size_t line;
    };
    const auto file = [](const std::string& line) {
        return "<jausconfig thissystem='a'>\n" + net_test::system_a + line + "\n</jausconfig>\n";
    };
    const std::string b = "<system name='b' jausip='2.0.0.0' ip='127.0.0.1' port='39778'";
    std::string addresses;
    for (int i = 0; i != 8; ++i) addresses += "<ip>10.0.0." + std::to_string(i) + "</ip>";
    for (const row& one : {
             row{"<jausconfig>", config_errc::not_xml, "", 1},
             row{"<configuration/>", config_errc::wrong_root, "configuration", 1},
             row{file("stray"), config_errc::unexpected, "jausconfig", 2},
             row{file(b + "><framing><a/></framing></system>"), config_errc::unexpected, "framing", 3},
             row{file(b + " colour='red'/>"), config_errc::unknown_name, "colour", 3},
             row{file("<system name='b'/>"), config_errc::missing, "jausip", 3},
             row{"<jausconfig>\n" + net_test::system_a + "</jausconfig>", config_errc::missing, "thissystem", 1},
             row{file(net_test::system_a), config_errc::duplicate, "name", 3},
             row{file(b + "><limits/><limits/></system>"), config_errc::duplicate, "limits", 3},
             row{file(b + "><node id='1'/><node id='1'/></system>"), config_errc::duplicate, "id", 3},
             row{file(b + '>' + addresses + "</system>"), config_errc::too_many, "ip", 3},
             row{file("<system name='b' jausip='2' ip='127.0.0.1' port='1'/>"), config_errc::invalid_value, "jausip",
                 3},
             row{file(b + " framing='jaus'/>"), config_errc::invalid_value, "framing", 3},
             row{file(b + "><limits rate='-1'/></system>"), config_errc::invalid_value, "rate", 3},
             row{"<jausconfig thissystem='c'>" + net_test::system_a + "</jausconfig>", config_errc::no_such_system,
                 "thissystem", 1},
             row{file(b + "><multicast group='ff15::1'/></system>"), config_errc::inconsistent, "group", 3},
             row{file(b + "><ethernet/></system>"), config_errc::unknown_name, "ethernet", 3},
             row{file(b + "><ethercat interface='eth0'/></system>"), config_errc::inconsistent, "ethercat", 3},
         }) {
        CAPTURE(one.text);
        try {
            static_cast<void>(net::parse_jaus_config(one.text, "test.xml"));
            FAIL("accepted");
        } catch (const config_error& error) {
            CHECK(error.code() == one.code);
            CHECK(error.name() == one.name);
            CHECK(error.line() == one.line);
            CHECK(describe(error.code()) != "unknown error");
        }
    }
}

TEST_CASE("malformed XML is refused with its line") {
    CHECK(complaint("") == "test.xml:1: not well-formed XML: No document element found");
    CHECK(complaint("hello") == "test.xml:1: not well-formed XML: No document element found");
    CHECK(complaint("<jausconfig>\n<system>\n</jausconfig>").starts_with("test.xml:3: not well-formed XML: Start-end"));
    CHECK(complaint("<jausconfig>\n<system name='a>\n</jausconfig>").starts_with("test.xml:2: not well-formed XML: "));
    CHECK(complaint("<config/>") == "test.xml:1: the root element is <config>; it must be <jausconfig>");
    CHECK(complaint("<jausconfig thissystem='a'>" + system_a + "</jausconfig>\n<jausconfig/>") ==
          "test.xml:3: something follows </jausconfig>; remove it");
}

TEST_CASE("a file without systems, or without a valid thissystem, is refused") {
    CHECK(complaint("<jausconfig thissystem='a'/>").starts_with("test.xml:1: no <system>; give at least one"));
    CHECK(complaint("<jausconfig>\n" + system_a + "</jausconfig>").starts_with("test.xml:1: no <thissystem>; "));
    CHECK(complaint("<jausconfig>\n" + system_a + "<thissystem>c</thissystem></jausconfig>") ==
          "test.xml:3: there is no system \"c\"; the file has: a");
    CHECK(complaint("<jausconfig thissystem='a'>\n" + system_a + "<thissystem>a</thissystem></jausconfig>") ==
          "test.xml:3: \"thissystem\" is given twice in <jausconfig>; keep one");
}

TEST_CASE("a system's missing, unknown, repeated or invalid value is refused with its line") {
    const auto with = [](const std::string& name, const std::string& jausip, const std::string& ip,
                         const std::string& port, const std::string& more = {}) {
        return complaint_about("<system><name>" + name + "</name><jausip>" + jausip + "</jausip><ip>" + ip +
                               "</ip><port>" + port + "</port>" + more + "</system>");
    };
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "39777") == "accepted");
    CHECK(with("a", "2.0.0.0", "10.0.0.2", "39777") ==
          "test.xml:3: the name \"a\" is taken by the <system> in line 2; give each its own");
    CHECK(with("b", "1.0.0.0", "10.0.0.2", "39777") ==
          "test.xml:3: the jausip 1.0.0.0 is taken by the <system> in line 2; give each its own");
    CHECK(
        with("b", "255.0.0.0", "10.0.0.2", "1").starts_with("test.xml:3: jausip \"255.0.0.0\" is not subsystem.node"));
    CHECK(with("b", "2.0.0", "10.0.0.2", "1").starts_with("test.xml:3: jausip \"2.0.0\" is not subsystem.node"));
    CHECK(with("b", "2.0.0.0", "10.0.0", "1") == "test.xml:3: ip \"10.0.0\" is not an IP address, such as 127.0.0.1");
    for (const auto* port : {"0", "65536", "-1", "x", "1x", "1 2"})
        CHECK(with("b", "2.0.0.0", "10.0.0.2", port) ==
              "test.xml:3: port \"" + std::string{port} + "\" is not a UDP port, 1 to 65535");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "1", "<framing>JAUS02</framing>") ==
          "test.xml:3: framing \"JAUS02\" is unknown; use bare, JAUS01.0 or judp1");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "") == "test.xml:3: this <system> needs <port>");
    CHECK(with("", "2.0.0.0", "10.0.0.2", "1") == "test.xml:3: this <system> needs <name>");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "1", "\n<colour>red</colour>") ==
          "test.xml:4: unknown \"colour\" in <system>; remove it or correct its name");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "1", "\n<port>2</port>") ==
          "test.xml:4: \"port\" is given twice in <system>; keep one");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "1", "\nhm") == "test.xml:3: stray text in <system>; remove it");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "<b>1</b>") == "test.xml:3: <port> takes a plain text and nothing else");
    CHECK(with("b", "2.0.0.0", "10.0.0.2", "1<b>1</b>") == "test.xml:3: <port> takes a plain text and nothing else");
    CHECK(complaint_about("<system name='b' jausip='2.0.0.0' ip='10.0.0.2' port='1' baud='9600'/>") ==
          "test.xml:3: unknown \"baud\" in <system>; remove it or correct its name");
    CHECK(complaint_about("<system name='b' jausip='2.0.0.0' port='1'/>") == "test.xml:3: this <system> needs <ip>");
    CHECK(complaint_about("<system name='b' ip='10.0.0.2' port='1'/>") == "test.xml:3: this <system> needs <jausip>");
    CHECK(complaint_about("<sytem name='b' jausip='2.0.0.0' ip='10.0.0.2' port='1'/>") ==
          "test.xml:3: unknown \"sytem\" in <jausconfig>; remove it or correct its name");
}

TEST_CASE("all mistakes of a configuration are told in one run, by line") {
    const std::string text = "<jausconfig thissystem='a'>\n"
                             "<system name='a' jausip='1.0.0' ip='127.0.0.1' port='0' colour='red'/>\n" // line 2
                             "<system name='b' jausip='2.0.0.0' ip='127.0.0'\n"
                             "        port='3794' framing='raw'>\n"
                             "  <limits rate='many'/>\n" // line 5
                             "  <component id='300'/>\n"
                             "  <component id='33' authority='high'/>\n"
                             "</system>\n"
                             "<system name='c' jausip='3.0.0.0'/>\n"
                             "</jausconfig>\n";
    CHECK(
        complaint(text) ==
        "test.xml:2: unknown \"colour\" in <system>; remove it or correct its name\n"
        "test.xml:2: jausip \"1.0.0\" is not subsystem.node.component.instance, each 0 (all) to 254, such as 1.0.0.0\n"
        "test.xml:2: port \"0\" is not a UDP port, 1 to 65535\n"
        "test.xml:3: ip \"127.0.0\" is not an IP address, such as 127.0.0.1\n"
        "test.xml:3: framing \"raw\" is unknown; use bare, JAUS01.0 or judp1\n"
        "test.xml:5: rate \"many\" is not a number of messages each second (0: no limit), 0 to 1000000000\n"
        "test.xml:6: id \"300\" is not a component's ID, 1 to 254\n"
        "test.xml:7: authority \"high\" is not an authority code, 0 to 255\n"
        "test.xml:9: this <system> needs <ip>\n"
        "test.xml:9: this <system> needs <port>");
}
