// esi of jauscat-ecat: slaves compared with device files.
#include "ecat/tool.hpp"
#include "support/catch.hpp"
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/write_esi.hpp>

using namespace ecat_test;

namespace {

const std::vector<ethercat::pdo_entry> inputs{
    {.index = 0x6000, .subindex = 1, .bits = 16, .data_type = 3, .name = "position"}};

ethercat::slave_description described() {
    return {.vendor = 7, .product = 1, .revision = 3, .name = "axis", .inputs = inputs};
}

void write_file(const std::string& path, const ethercat::slave_description& of) {
    std::ofstream{path} << jauscat::esi::write_esi(jauscat::esi::make_device(
        of, {.vendor_name = "someone", .group_type = "axes", .group_name = "axes", .type = "axis"}, {}, false));
}

json row(const outcome& ended, const std::string& what) {
    for (const auto& each : ended.parsed())
        if (each["what"] == what) return each;
    return nullptr;
}

} // namespace

TEST_CASE("esi compares identity, SyncManagers, FMMUs and PDOs with a file") {
    const scratch files;
    write_file(files / "axis.xml", described());
    auto other = described();
    other.revision = 4;
    const emulated_bus ring{{described(), other}};
    const auto same = run("esi " + (files / "axis.xml") + " --slave 0 --format json" + on(ring));
    INFO(same.out << same.err);
    CHECK(same.code == done);
    CHECK(same.complains("objects are not compared")); // there is no SDO information
    CHECK(row(same, "vendor")["same"] == true);
    CHECK(row(same, "revision")["same"] == true);
    CHECK(row(same, "SyncManager 0")["same"] == true);
    CHECK(row(same, "SyncManager 3")["same"] == true);
    CHECK(row(same, "PDO 0x1A00")["same"] == true);
    const auto differs = run("esi " + (files / "axis.xml") + " --slave 1 --format json" + on(ring));
    CHECK(differs.code == failed);
    CHECK(row(differs, "revision") ==
          json{{"what", "revision"}, {"same", false}, {"file", "0x00000003"}, {"slave", "0x00000004"}});
    CHECK(run("esi " + (files / "axis.xml") + " --slave 1" + on(ring))
              .says("DIFFERS  revision        file:  0x00000003\n"
                    "                         slave: 0x00000004"));
}

TEST_CASE("esi chooses the device of a file by the slave") {
    const scratch files;
    // Product 1 in revisions 2 and 5, and product 2.
    const auto text = [](std::uint32_t product, std::uint32_t revision) {
        auto of = described();
        of.product = product;
        of.revision = revision;
        return jauscat::esi::write_esi(jauscat::esi::make_device(
            of, {.vendor_name = "someone", .group_type = "axes", .group_name = "axes", .type = "axis"}, {}, false));
    };
    const auto device = [](const std::string& xml) {
        const auto begin = xml.find("<Device "), end = xml.find("</Devices>");
        return xml.substr(begin, end - begin);
    };
    auto all = text(1, 2);
    all.insert(all.find("</Devices>"), device(text(1, 5)) + device(text(2, 3)));
    std::ofstream{files / "axes.xml"} << all;
    auto newer = described();
    newer.revision = 4;
    auto other = described();
    other.product = 3;
    const emulated_bus ring{{described(), newer, other}};
    // The slave has revision 3: the file of 2 describes it, but for the revision itself.
    const auto found = run("esi " + (files / "axes.xml") + " --slave 0 --format json" + on(ring));
    INFO(found.out << found.err);
    CHECK(found.code == failed);
    CHECK(row(found, "product")["same"] == true);
    CHECK(row(found, "revision") ==
          json{{"what", "revision"}, {"same", false}, {"file", "0x00000002"}, {"slave", "0x00000003"}});
    CHECK(row(found, "PDO 0x1A00")["same"] == true);
    CHECK(row(run("esi " + (files / "axes.xml") + " --slave 1 --format json" + on(ring)), "revision")["file"] ==
          "0x00000002");
    const auto absent = run("esi " + (files / "axes.xml") + " --slave 2" + on(ring));
    CHECK(absent.code == failed);
    CHECK(absent.complains("no <Device> is product #x00000003, revision #x00000003"));
}

TEST_CASE("esi says what is wrong with a file") {
    const scratch files;
    const emulated_bus ring{{described()}};
    const auto missing = run("esi " + (files / "none.xml") + on(ring));
    CHECK(missing.code == failed);
    CHECK(missing.complains("none.xml"));
    std::ofstream{files / "text.xml"} << "no XML";
    const auto broken = run("esi " + (files / "text.xml") + on(ring));
    CHECK(broken.code == failed);
    CHECK(broken.complains("text.xml"));
}
