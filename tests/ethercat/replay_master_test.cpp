// The slave's side of recorded traffic, replayed against our master: it comes to the results the recorded master had.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/pcap.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/master.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::read_pcap;
using jauscat::test::simulated_link;
using jauscat::test::to_hex;
namespace wire = jauscat::wire;

namespace {

using bytes = std::vector<std::byte>;

// A slave with recorded data only: its SII words, and its answer to each mailbox message.
class recorded_slave {
  public:
    explicit recorded_slave(const char* capture) {
        std::uint32_t sii_word = 0;
        bytes request;
        const auto frames = read_pcap(capture);
        for (std::size_t i = 1; i < frames.size(); i += 2) {
            frame_view view;
            REQUIRE(view.parse(frames[i]));
            for (const auto d : view) {
                const bytes data(d.data.begin(), d.data.end());
                if (d.header.ado == 0x0502 && d.header.length == 6) {
                    sii_request asked{};
                    REQUIRE(wire::decode(asked, data));
                    sii_word = asked.address;
                } else if (d.header.ado == 0x0508) {
                    sii_[sii_word] = data;
                } else if (d.header.ado == 0x1000) {
                    request = data;
                } else if (d.header.ado == 0x1400) {
                    answers_.emplace_back(request, data);
                }
            }
        }
    }

    void process(std::span<std::byte> frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) execute(d);
    }

    [[nodiscard]] std::size_t unused_answers() const { return answers_.size(); }

  private:
    void execute(const basic_datagram<std::byte>& d) {
        const auto& header = d.header;
        if ((header.cmd == command::fprd || header.cmd == command::fpwr) && header.adp != station_) return;
        bool executed = true;
        const auto as = [&](auto value) {
            REQUIRE(wire::decode(value, d.data));
            return value;
        };
        const auto give = [&](const auto& value) { REQUIRE(wire::encode(value, d.data)); };
        switch (header.ado) {
        case 0x0000: d.data[0] = std::byte{4}; break;
        case 0x0010:
            if (header.cmd == command::apwr)
                station_ = as(esc_word{}).value;
            else
                give(esc_word{station_});
            break;
        case 0x0120: state_ = as(al_control{}).state; break;
        case 0x0130: give(al_status{.state = state_}); break;
        case 0x0500:
        case 0x0800: break;
        case 0x0502:
            if (header.cmd == command::fpwr) {
                sii_word_ = as(sii_request{}).address;
                REQUIRE(sii_.contains(sii_word_)); // our master reads nothing that the recorded one did not
            } else {
                sii_access access{};
                std::ranges::copy(sii_.at(sii_word_), access.data.begin());
                give(access);
            }
            break;
        case 0x1000: executed = post({d.data.begin(), d.data.end()}); break;
        case 0x1400:
            executed = !mail_.empty();
            std::ranges::copy(mail_, d.data.begin());
            mail_.clear();
            break;
        default: FAIL("our master uses a register the recorded one did not: " << header.ado);
        }
        if (executed) REQUIRE(wire::encode(datagram_trailer{1}, d.bytes.last(2)));
    }

    // The recorded answer to the same request, in recorded order. Counters and, for KickCAT, the size bit may differ.
    bool post(const bytes& request) {
        const auto essence = [](const bytes& message) {
            bytes all{message.begin(), message.begin() + 6 + std::to_integer<int>(message[0])};
            all[5] &= std::byte{0x0F};
            if (all[8] == std::byte{0x20}) all[8] = std::byte{0x21};
            return to_hex(all);
        };
        REQUIRE_FALSE(answers_.empty());
        REQUIRE(essence(request) == essence(answers_.front().first));
        mail_ = answers_.front().second;
        answers_.erase(answers_.begin());
        return true;
    }

    std::map<std::uint32_t, bytes> sii_{};
    std::vector<std::pair<bytes, bytes>> answers_{};
    std::uint16_t station_{};
    al_state state_{al_state::init};
    std::uint32_t sii_word_{};
    bytes mail_{};
};

struct bench {
    recorded_slave device;
    simulated_link link{[this](std::span<std::byte> frame) { device.process(frame); }};
    master_for<16> master{};

    explicit bench(const char* capture, std::uint16_t station) : device{capture}, station_{station} {
        REQUIRE(link.run(master, bring_up{0, station}));
        REQUIRE(master.slaves().size() == 1);
    }
    master_result<> download(std::uint16_t index, std::uint8_t subindex, const bytes& data) {
        return link.run(master, jauscat::ethercat::download{station_, index, subindex, data});
    }
    std::string upload(std::uint16_t index, std::uint8_t subindex) {
        bytes into(64);
        const auto result = link.run(master, jauscat::ethercat::upload{station_, index, subindex, into});
        return result ? to_hex(*result) : std::string{describe_reason(result.error())};
    }

  private:
    std::uint16_t station_;
};

master_result<> aborted(abort_code code) { return master_error{.code = master_errc::sdo_abort, .abort = code}; }

} // namespace

TEST_CASE("our master gets the same results with SOES as SOEM did") {
    bench b{"ethercat_soem_soes.pcap", 0x1001};
    const auto& slave = b.master.slaves().front();
    CHECK(slave.identity.vendor == 0x6A5);
    CHECK(slave.identity.product == 0x0BADB001);
    CHECK(slave.mailbox.receive_size == 128);
    CHECK(slave.mailbox.send_offset == 0x1400);

    const auto payload = from_hex("05048ba2e81c7e8c98c80abef712b37565f567f3fea96c7f496cac27");
    CHECK(b.download(0x1B1A, 1, payload) == aborted(abort_code::subindex_0_not_zero));
    CHECK(b.upload(0x1B1A, 1) == to_hex(bytes(28)));
    CHECK(b.download(0x6926, 1, payload));
    CHECK(b.upload(0x6926, 1) == to_hex(payload));
    CHECK(b.download(0x2001, 0, from_hex("44332211")));
    CHECK(b.upload(0x2001, 0) == "44 33 22 11");
    CHECK(b.download(0x2002, 0, from_hex("5a")));
    CHECK(b.upload(0x2002, 0) == "5a");
    CHECK(b.download(0x2010, 0, from_hex("44332211")) == aborted(abort_code::read_only));
    CHECK(b.upload(0x5555, 1) == "no such object in the dictionary");
    CHECK(b.download(0x1B1A, 0, from_hex("00")));
    CHECK(b.download(0x1B1A, 1, payload));
    CHECK(b.upload(0x1B1A, 1) == to_hex(payload));
    CHECK(b.device.unused_answers() == 0);
    CHECK(b.master.statistics().sent == 24 + 1 + 13 * 2);
}

TEST_CASE("our master gets the same results with KickCAT's slave as KickCAT's master did") {
    bench b{"ethercat_kickcat.pcap", 1001};
    CHECK(b.master.slaves().front().mailbox.receive_size == 512);
    const auto payload = from_hex("000000001d242b323940474e555c636a71787f868d949ba2a9b0b7be");
    CHECK(b.download(0x6926, 1, payload)); // answered with the request's own length and data
    CHECK(b.upload(0x6926, 1) == to_hex(payload));
    CHECK(b.device.unused_answers() == 0);
}
