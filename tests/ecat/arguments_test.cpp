// Command lines of jauscat-ecat, and links that do not work.
#include "ecat/tool.hpp"
#include "support/catch.hpp"

using namespace ecat_test;

TEST_CASE("jauscat-ecat explains itself and each command") {
    const auto all = run("--help");
    CHECK(all.code == done);
    for (const std::string command :
         {"scan", "info", "state", "read", "write", "sdos", "sii", "pdos", "watch", "monitor", "esi"}) {
        INFO(command);
        CHECK(all.says("  " + command + " "));
        const auto one = run(command + " --help");
        CHECK(one.code == done);
        CHECK(one.says("Usage: jauscat-ecat " + command));
        CHECK(one.says("Examples:"));
        CHECK(one.err.empty());
    }
    CHECK(run("--version").says("JausCat"));
    CHECK(run("-h").code == done);
}

TEST_CASE("jauscat-ecat says what is wrong with a command line") {
    const auto [arguments, text] = GENERATE(table<std::string, std::string>({
        {"", "a command is missing"},
        {"frob --link lo", "'frob' is no command"},
        {"scan", "--link is missing"},
        {"scan --link", "required argument"},
        {"scan extra --link lo", "'extra' is not expected"},
        {"scan --link lo --slave 1", "scan has no option --slave"},
        {"scan --link lo --format xml", "--format must be text or json, not 'xml'"},
        {"scan --link lo --frob", "unrecognised option"},
        {"info --link lo --slave x", "--slave must be 0 to 65534, not 'x'"},
        {"info --link lo --slave -1", "--slave must be 0 to 65534"},
        {"info --link lo --slave 1 --alias 2", "not both"},
        {"scan --link lo --frame-timeout 0", "--frame-timeout must be 1 to 10000"},
        {"state sleeping --link lo", "'sleeping' is no state"},
        {"state sleeping --link lo", "expected init, pre-op, boot, safe-op or op"},
        {"read --link lo", "expected INDEX"},
        {"read 10000000 --link lo", "is no object"},
        {"read 0x1018:300 --link lo", "is no object"},
        {"read 0x1018:4-1 --link lo", "is no object"},
        {"read 0x1018 --type u9 --link lo", "--type 'u9' is unknown"},
        {"write 0x2000 --link lo", "expected INDEX[:SUB] VALUE"},
        {"write 0x2000 256 --type u8 --link lo", "expected 0 to 255"},
        {"write 0x2000 -129 --type i8 --link lo", "expected -128 to 127"},
        {"write 0x2000 0fg --type bytes --link lo", "expected hexadecimal digits"},
        {"write 0x2000 maybe --type bool --link lo", "expected true or false"},
        {"write 0x2000 1e99 --type f32 --link lo", "expected a number such as 1.5"},
        {"sdos 0x6fff-0x6000 --link lo", "is no range of objects"},
        {"monitor --link lo --period 0", "--period must be 50 to 60000000"},
        {"watch --link lo --seconds never", "--seconds must be a time"},
        {"sii --link lo --yes", "sii has no option --yes"},
    }));
    const auto ended = run(arguments);
    INFO(arguments << "\n" << ended.err);
    CHECK(ended.code == usage);
    CHECK(ended.complains(text));
    CHECK(ended.complains("Try 'jauscat-ecat --help'."));
    CHECK(ended.out.empty());
}

TEST_CASE("jauscat-ecat says why a link does not work") {
    SECTION("no such interface") {
        const auto ended = run("scan --link nope0");
        CHECK(ended.code == failed);
        // Without the capability it does not get as far.
        CHECK((ended.complains("there is no interface nope0") || ended.complains("CAP_NET_RAW")));
    }
    SECTION("a wrong address") {
        const auto ended = run("scan --link udp:127.0.0.1:99999");
        CHECK(ended.code == failed);
        CHECK(ended.complains("the port is not 1 to 65535"));
    }
    SECTION("a closed port") {
        std::string where;
        {
            const emulated_bus ring{three()};
            where = ring.where();
        }
        for (const std::string command : {"scan", "info", "state", "read 0x1008 --slave 0"}) {
            const auto ended = run(command + " --link " + where);
            CHECK(ended.code == failed);
            CHECK(ended.complains("no slave receives at UDP " + where.substr(4)));
            CHECK(ended.out.empty());
        }
    }
    SECTION("no frame returns") {
        emulated_bus ring{three()};
        ring.is_silent = true;
        const auto ended = run("scan" + on(ring));
        CHECK(ended.code == failed);
        CHECK(ended.complains("frames do not return"));
    }
    SECTION("garbage returns") {
        emulated_bus ring{three()};
        ring.is_garbage = true;
        const auto ended = run("scan" + on(ring));
        CHECK(ended.code == failed);
        CHECK(ended.complains("frames do not return"));
        CHECK(ended.out.empty());
    }
    SECTION("frames return, but no slave takes part") {
        emulated_bus ring{three()};
        ring.cut_behind(0);
        const auto ended = run("scan" + on(ring));
        CHECK(ended.code == failed);
        CHECK(ended.complains("no slave has taken part"));
    }
}
