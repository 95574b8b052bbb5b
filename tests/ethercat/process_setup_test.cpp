// What `configure` makes of slaves whose SII or objects differ from the usual: uses and directions that are not given,
// assignment objects that are missing, virtual SyncManagers, controllers without LRW.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/text/master_error_text.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::simulated_link;
using jauscat::test::to_hex;

namespace {

using bytes = std::vector<std::byte>;

constexpr std::array<pdo_entry, 2> target{pdo_entry{0x6040, 0, 16, 6, "control word"},
                                          pdo_entry{0x607A, 0, 32, 4, "target position"}};
constexpr std::array<pdo_entry, 1> status{pdo_entry{0x6041, 0, 16, 6, "status word"}};
const slave_description drive{.vendor = 1, .product = 2, .outputs = target, .inputs = status};

/// A SII that is put together, with SyncManagers at 1000h, 1080h and from 1100h on.
class sii {
  public:
    struct manager {
        std::uint16_t start{}, length{};
        unsigned control{}, enable{1}, use{};
    };
    sii& general(unsigned flags) {
        bytes content(32);
        content[11] = static_cast<std::byte>(flags);
        return add(30, content);
    }
    sii& managers(const std::vector<manager>& all) {
        bytes content;
        for (const auto& one : all) {
            word(content, one.start);
            word(content, one.length);
            for (const unsigned value : {one.control, 0U, one.enable, one.use}) content.push_back(std::byte(value));
        }
        return add(41, content);
    }
    /// A PDO with one entry.
    sii& pdo(bool outputs, unsigned index, unsigned carrier, unsigned bits) {
        bytes content;
        word(content, index);
        for (const unsigned value : {1U, carrier, 0U, 0U, 0U, 0U}) content.push_back(std::byte(value));
        word(content, 0x7000);
        for (const unsigned value : {1U, 0U, 5U, bits, 0U, 0U}) content.push_back(std::byte(value));
        return add(outputs ? 51 : 50, content);
    }
    [[nodiscard]] bytes categories() const {
        auto all = content_;
        word(all, 0xFFFF);
        all.resize(4096, std::byte{0xFF});
        return all;
    }

  private:
    static void word(bytes& to, unsigned value) {
        to.push_back(std::byte(value & 0xFF));
        to.push_back(std::byte(value >> 8 & 0xFF));
    }
    sii& add(unsigned category, const bytes& content) {
        word(content_, category);
        word(content_, static_cast<unsigned>(content.size() / 2));
        content_.insert(content_.end(), content.begin(), content.end());
        return *this;
    }
    bytes content_{};
};

const sii::manager out_mailbox{0x1000, 128, 0x26, 1, 1}, in_mailbox{0x1080, 128, 0x22, 1, 2};

struct bench {
    jauscat::test::objects objects{};
    slave_description description;
    standard_objects standard{description, objects};
    slave device;
    simulated_link link{[this](std::span<std::byte> frame) {
        device.pass(frame);
        device.work();
    }};
    master_for<2> master{};
    /// Looks at an SDO message of the slave, and may change it: command, index, subindex, data.
    std::function<void(std::span<std::byte>)> on_sdo{};
    /// SyncManagers that were switched on.
    std::vector<unsigned> switched_on{};

    /// A slave of `d` whose SII has these categories.
    explicit bench(const slave_description& d, const sii& with) : description{d}, device{d, standard} {
        link.on_way_back = [this, from = with.categories()](bytes& frame) {
            mutable_frame_view view;
            REQUIRE(view.parse(frame));
            for (const auto each : view) look(each, from);
        };
    }
    bool up() { return link.run(master, bring_up{0, 1}).has_value(); }
    configure::result_type set_up() {
        REQUIRE(up());
        return link.run(master, configure{1});
    }

  private:
    void look(const auto& datagram, const bytes& from) {
        const auto& head = datagram.header;
        if (datagram.working_counter == 0) return;
        if (head.ado == 0x0502 && head.cmd == command::fprd) {
            const auto word = std::to_integer<unsigned>(datagram.data[2]) | std::to_integer<unsigned>(datagram.data[3])
                                                                                << 8;
            if (word < 0x40) return;
            const auto at = std::span{from}.subspan((word - 0x40) * 2, datagram.data.size() - 6);
            std::ranges::copy(at, datagram.data.subspan(6).begin());
        }
        if (head.cmd == command::fprd && head.ado == description.mailbox_in_offset && on_sdo)
            on_sdo(datagram.data.subspan(8));
        if (head.cmd == command::fpwr && head.ado >= 0x0810 && head.ado < 0x0880 &&
            (datagram.data[6] & std::byte{1}) != std::byte{})
            switched_on.push_back((head.ado - 0x0800U) / 8);
    }
};

slave_description without_mailbox(slave_description made) {
    made.mailbox_out_size = made.mailbox_in_size = 0;
    return made;
}

void no_such_object(std::span<std::byte> sdo) {
    std::ranges::copy(from_hex("80"), sdo.begin());
    std::ranges::copy(from_hex("00000206"), sdo.subspan(4).begin());
}

} // namespace

TEST_CASE("the direction of a SyncManager without a use is that of its control byte") {
    bench b{drive, sii{}.managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 0}, {0x1200, 0, 0x20, 1, 0}})};
    const auto made = b.set_up();
    REQUIRE(made);
    CHECK(made->output_size == 6);
    CHECK(made->input_size == 2);
    CHECK(b.switched_on == std::vector<unsigned>{2, 3});
}

TEST_CASE("the direction of a SyncManager without use and control byte is that of its PDOs") {
    const std::vector<sii::manager> managers{out_mailbox, in_mailbox, {0x1100, 0, 0, 1, 0}, {0x1200, 0, 0, 1, 0}};
    SECTION("that its objects assign") {
        bench b{drive, sii{}.managers(managers)};
        const auto made = b.set_up();
        REQUIRE(made);
        CHECK(made->output_size == 6);
        CHECK(made->input_size == 2);
    }
    SECTION("that the SII assigns") {
        bench b{without_mailbox(drive), sii{}
                                            .managers({{0x1100, 0, 0, 1, 0}, {0x1200, 0, 0, 1, 0}})
                                            .pdo(true, 0x1600, 0, 16)
                                            .pdo(false, 0x1A00, 1, 8)};
        const auto made = b.set_up();
        REQUIRE(made);
        CHECK(made->output_size == 2);
        CHECK(made->input_size == 1);
    }
    SECTION("which are of both directions") {
        bench b{without_mailbox(drive),
                sii{}.managers({{0x1100, 0, 0, 1, 0}}).pdo(true, 0x1600, 0, 16).pdo(false, 0x1A00, 0, 8)};
        const auto made = b.set_up();
        CHECK(made.error() == master_error{.code = master_errc::no_direction});
        CHECK(jauscat::text::explain(made.error()).starts_with("SyncManager 0: nothing says whether"));
    }
    SECTION("that are not there: it has a length alone") {
        bench b{without_mailbox(drive), sii{}.managers({{0x1100, 2, 0x64, 1, 3}, {0x1200, 4, 0, 1, 0}})};
        CHECK(b.set_up().error() == master_error{.code = master_errc::no_direction, .sync_manager = 1});
    }
    SECTION("that are not there: it is not in use") {
        bench b{without_mailbox(drive),
                sii{}.managers({{0x1100, 2, 0x64, 1, 3}, {0x1200, 4, 0, 0, 0}, {0, 0, 0, 0, 0}})};
        const auto made = b.set_up();
        REQUIRE(made);
        CHECK(made->output_size == 2);
        CHECK(made->input_size == 0);
    }
}

TEST_CASE("a missing assignment object leaves the SII's size to its SyncManager alone") {
    const auto missing = GENERATE(0x1C12, 0x1C13);
    const bool is_in_sii = GENERATE(false, true);
    sii image;
    image.managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}});
    if (is_in_sii) image.pdo(true, 0x1600, 2, 8).pdo(false, 0x1A00, 3, 8);
    bench b{drive, image};
    b.on_sdo = [&](std::span<std::byte> sdo) {
        if (to_hex(sdo.subspan(1, 2)) == (missing == 0x1C12 ? "12 1c" : "13 1c")) no_such_object(sdo);
    };
    const auto made = b.set_up();
    REQUIRE(made);
    const std::uint16_t of_sii = is_in_sii ? 1 : 0;
    CHECK(made->output_size == (missing == 0x1C12 ? of_sii : 6));
    CHECK(made->input_size == (missing == 0x1C13 ? of_sii : 2));
}

TEST_CASE("a mailbox that does not know CoE leaves all to the SII") {
    bench b{drive, sii{}
                       .managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}})
                       .pdo(true, 0x1600, 2, 16)
                       .pdo(false, 0x1A00, 3, 32)};
    b.on_sdo = [](std::span<std::byte> sdo) { // an error of the mailbox, of the type 1 and the code 2
        auto* const message = sdo.data() - 8;
        std::ranges::copy(from_hex("0400 0000 00 00 0100 0200"), message);
    };
    const auto made = b.set_up();
    REQUIRE(made);
    CHECK(made->output_size == 2);
    CHECK(made->input_size == 4);
}

TEST_CASE("objects get their places in the process data") {
    std::array<process_object, 4> wanted{
        process_object{.index = 0x6041}, process_object{.index = 0x607A, .is_output = true},
        process_object{.index = 0x6040, .is_output = true}, process_object{.index = 0x607A}}; // an output only
    wanted[3].bits = 8;                                                                       // of an earlier search
    SECTION("by the slave's objects") {
        bench b{drive, sii{}.managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}})};
        REQUIRE(b.up());
        REQUIRE(b.link.run(b.master, configure{.station = 1, .objects = wanted}));
        CHECK(wanted[0].bits == 16);
        CHECK(wanted[0].first_bit == 0);
        CHECK(wanted[1].bits == 32);
        CHECK(wanted[1].first_bit == 16);
        CHECK(wanted[2].bits == 16);
        CHECK(wanted[2].first_bit == 0);
        CHECK(wanted[3].bits == 0);
    }
    SECTION("by the SII, behind those of the SyncManagers before") {
        bench b{without_mailbox(drive), sii{}
                                            .pdo(true, 0x1601, 1, 32)
                                            .managers({{0x1100, 0, 0x64, 1, 3},
                                                       {0x1200, 0, 0x64, 1, 3},
                                                       {0x1300, 0, 0x20, 1, 4},
                                                       {0x1400, 0, 0x20, 1, 4}})
                                            .pdo(true, 0x1600, 0, 12)
                                            .pdo(false, 0x1A00, 2, 8)
                                            .pdo(false, 0x1A01, 3, 8)};
        // All entries are 7000h:1: the first in the order of the SII counts.
        std::array<process_object, 2> both{process_object{.index = 0x7000, .subindex = 1, .is_output = true},
                                           process_object{.index = 0x7000, .subindex = 1}};
        REQUIRE(b.up());
        REQUIRE(b.link.run(b.master, configure{.station = 1, .objects = both}));
        CHECK(both[0].bits == 32);
        CHECK(both[0].first_bit == 16); // 12 bits are 2 bytes
        CHECK(both[1].bits == 8);
        CHECK(both[1].first_bit == 0);
    }
    SECTION("where the SII counts for one SyncManager only") {
        bench b{drive, sii{}
                           .managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}})
                           .pdo(true, 0x1600, 2, 32)
                           .pdo(false, 0x1A00, 3, 8)};
        b.on_sdo = [&](std::span<std::byte> sdo) {
            if (to_hex(sdo.subspan(1, 2)) == "13 1c") no_such_object(sdo);
        };
        std::array<process_object, 2> both{process_object{.index = 0x7000, .subindex = 1, .is_output = true},
                                           process_object{.index = 0x7000, .subindex = 1}};
        REQUIRE(b.up());
        REQUIRE(b.link.run(b.master, configure{.station = 1, .objects = both}));
        CHECK(both[0].bits == 0); // the objects of the slave say what its outputs are
        CHECK(both[1].bits == 8);
    }
}

TEST_CASE("a virtual SyncManager is not switched on, an FMMU maps its place") {
    bench b{without_mailbox(drive),
            sii{}
                .managers({{0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}, {0x0998, 0, 0, 4, 4}})
                .pdo(true, 0x1600, 0, 16)
                .pdo(false, 0x1A00, 1, 8)
                .pdo(false, 0x1A01, 2, 32)};
    const auto made = b.set_up();
    REQUIRE(made);
    CHECK(made->output_size == 2);
    CHECK(made->input_size == 5);
    CHECK(made->input_managers == 2);
    CHECK(std::ranges::find(b.switched_on, 2U) == b.switched_on.end());
}

TEST_CASE("a slave may have process data of eight SyncManagers") {
    const slave_description plain{.vendor = 1, .product = 2};
    sii image;
    std::vector<sii::manager> managers;
    for (std::uint16_t i = 0; i != 8; ++i)
        managers.push_back(
            {static_cast<std::uint16_t>(0x1100 + 16 * i), 0, i % 2 == 0 ? 0x64U : 0x20U, 1, i % 2 == 0 ? 3U : 4U});
    image.managers(managers);
    for (unsigned i = 0; i != 8; ++i) image.pdo(i % 2 == 0, i % 2 == 0 ? 0x1600 + i : 0x1A00 + i, i, 8);
    bench b{without_mailbox(plain), image};
    const auto made = b.set_up();
    REQUIRE(made);
    CHECK(made->output_size == 4);
    CHECK(made->input_size == 4);
    CHECK(made->output_managers == 4);
}

TEST_CASE("a slave whose SII says that it lacks LRW is exchanged with by LRD and LWR") {
    const bool lacks_it = GENERATE(false, true);
    bench b{drive, sii{}
                       .general(lacks_it ? 2 : 0)
                       .managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}})};
    const auto made = b.set_up();
    REQUIRE(made);
    CHECK(made->no_lrw == lacks_it);
}

TEST_CASE("an error of configuration names the object, and what was expected of it") {
    bench b{drive, sii{}.managers({out_mailbox, in_mailbox, {0x1100, 0, 0x64, 1, 3}, {0x1200, 0, 0x20, 1, 4}})};
    SECTION("a PDO that does not exist") {
        b.on_sdo = [](std::span<std::byte> sdo) {
            if (to_hex(sdo.subspan(1, 3)) == "00 1a 00") no_such_object(sdo);
        };
        const auto error = b.set_up().error();
        CHECK(error == master_error{.code = master_errc::sdo_abort, .index = 0x1A00, .abort = abort_code::no_object});
        CHECK(jauscat::text::explain(error) ==
              "object 0x1A00:0: the slave aborted the transfer: see the abort code: no such object in the dictionary "
              "(0x06020000)");
    }
    SECTION("a number that is too long") {
        b.on_sdo = [](std::span<std::byte> sdo) {
            if (to_hex(sdo.subspan(1, 3)) == "12 1c 00") sdo[0] = std::byte{0x43};
        };
        const auto error = b.set_up().error();
        CHECK(error == master_error{.code = master_errc::data_too_long, .index = 0x1C12, .bytes = 1, .found_bytes = 4});
        CHECK(jauscat::text::explain(error).ends_with("(1 bytes expected, 4 found)"));
    }
}
