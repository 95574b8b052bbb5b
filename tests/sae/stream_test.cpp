// Messages of AS5669A over TCP and serial lines, against literal bytes of a known peer.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/sae/transport/jserial.hpp>
#include <jauscat/sae/transport/jtcp.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

namespace sae = jauscat::sae;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using sae::transport_errc;
using bytes = std::vector<std::byte>;

const auto query_status = from_hex("00 1000 01 0a017e00 2201c800 0220 0100");
const auto query_frame = from_hex("1001 02 101000 1002 1a19 00 101000 01 0a017e00 2201c800 0220 0100 1003 1c73");
const auto stuffed_message = from_hex("00 1400 01 0a017e00 2201c800 0220 10031010 0200");
const auto stuffed_frame = from_hex("100102140010027a7e001400010a017e002201c80002201010031010101002001003fc48");

bytes joined(std::initializer_list<bytes> parts) {
    bytes all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// What a reader finds: the messages, and the errors between them, as text.
template <class Feed> std::vector<std::string> found_in(Feed feed) {
    std::vector<std::string> found;
    feed([&](const auto& one) {
        if constexpr (requires { one.bytes; })
            found.push_back(one ? to_hex(one.bytes) : std::string{describe(one.error)});
        else
            found.push_back(one ? to_hex(one.message) : std::string{describe(one.error)});
    });
    return found;
}
template <class Reader>
std::vector<std::string> read_in_pieces(const bytes& all, std::size_t piece, std::size_t memory = 64) {
    bytes buffer(memory);
    Reader reader{buffer};
    return found_in([&](auto take) {
        for (std::size_t at = 0; at < all.size(); at += piece)
            reader.on_bytes(std::span{all}.subspan(at, std::min(piece, all.size() - at)), take);
    });
}
std::string text(transport_errc error) { return std::string{describe(error)}; }

} // namespace

TEST_CASE("a connection begins with one version byte in front of its first message") {
    sae::jtcp_writer writer;
    bytes out(64);
    CHECK(writer.put(query_status, std::span{out}.first(16)).error() == transport_errc::no_space);
    CHECK(to_hex(*writer.put(query_status, out)) == to_hex(joined({from_hex("02"), query_status})));
    CHECK(to_hex(*writer.put(stuffed_message, out)) == to_hex(stuffed_message));
    CHECK(writer.put(query_status, std::span{out}.first(15)).error() == transport_errc::no_space);
}

TEST_CASE("messages of a connection are found whatever the pieces are") {
    const auto all = joined({from_hex("02"), query_status, stuffed_message, query_status});
    const std::vector expected{to_hex(query_status), to_hex(stuffed_message), to_hex(query_status)};
    for (std::size_t piece = 1; piece <= all.size(); ++piece)
        CHECK(read_in_pieces<sae::jtcp_reader>(all, piece) == expected);
}

TEST_CASE("a message of a connection that is larger than the memory is skipped") {
    const auto all = joined({from_hex("02"), query_status, stuffed_message, query_status});
    const std::vector expected{to_hex(query_status), text(transport_errc::too_large), to_hex(query_status)};
    for (std::size_t piece = 1; piece <= all.size(); ++piece)
        CHECK(read_in_pieces<sae::jtcp_reader>(all, piece, 16) == expected);
}

TEST_CASE("a connection with another version or an impossible size is to be closed") {
    bytes buffer(64);
    const auto error_after = [&](const bytes& all) {
        sae::jtcp_reader reader{buffer};
        reader.on_bytes(all, [](const auto&) {});
        return reader.error();
    };
    CHECK(error_after(joined({from_hex("01"), query_status})) == transport_errc::wrong_version);
    CHECK(error_after(from_hex("02 00 0d00 01 0a017e00 2201c800 0100")) == transport_errc::wrong_size);
    CHECK(error_after(from_hex("02 40 0f00 0000 01 0a017e00 2201c800 0100")) == transport_errc::wrong_size);
    CHECK(error_after(joined({from_hex("02"), query_status})) == transport_errc::ok);
}

TEST_CASE("a connection that ends inside of a message is seen") {
    bytes buffer(64);
    sae::jtcp_reader reader{buffer};
    const auto all = joined({from_hex("02"), query_status});
    CHECK_FALSE(reader.is_inside_message());
    reader.on_bytes(std::span{all}.first(16), [](const auto&) {});
    CHECK(reader.is_inside_message());
    reader.on_bytes(std::span{all}.last(1), [](const auto&) {});
    CHECK_FALSE(reader.is_inside_message());
}

TEST_CASE("a serial frame doubles each byte 10 that is no marker") {
    bytes out(128);
    CHECK(to_hex(*sae::put_serial_frame(query_status, out)) == to_hex(query_frame));
    CHECK(to_hex(*sae::put_serial_frame(stuffed_message, out)) == to_hex(stuffed_frame));
    CHECK(sae::put_serial_frame(query_status, std::span{out}.first(query_frame.size() - 1)).error() ==
          transport_errc::no_space);
    const bytes worst(20, std::byte{0x10});
    CHECK(sae::put_serial_frame(worst, out)->size() <= sae::max_serial_frame_size(worst.size()));
}

TEST_CASE("messages of a serial line are found whatever the pieces are") {
    const auto all = joined({query_frame, stuffed_frame, query_frame});
    const std::vector expected{to_hex(query_status), to_hex(stuffed_message), to_hex(query_status)};
    for (std::size_t piece = 1; piece <= all.size(); ++piece)
        CHECK(read_in_pieces<sae::jserial_reader>(all, piece) == expected);
}

TEST_CASE("noise around serial frames is reported once and hides none") {
    const auto noise = from_hex("55 10 55 1002 aa 10");
    const auto all = joined({noise, query_frame, noise, stuffed_frame});
    const std::vector expected{text(transport_errc::noise), to_hex(query_status), text(transport_errc::noise),
                               to_hex(stuffed_message)};
    for (std::size_t piece = 1; piece <= all.size(); ++piece)
        CHECK(read_in_pieces<sae::jserial_reader>(all, piece) == expected);
}

TEST_CASE("a cut serial frame is reported and the next one found") {
    for (std::size_t size = 2; size != query_frame.size(); ++size) {
        auto all = query_frame;
        all.resize(size);
        const auto found = read_in_pieces<sae::jserial_reader>(joined({all, query_frame, stuffed_frame}), 7);
        REQUIRE_FALSE(found.empty());
        CHECK(found.back() == to_hex(stuffed_message)); // a cut inside of a marker or a doubled byte costs a frame
    }
}

TEST_CASE("no changed byte of a serial frame gives another message") {
    for (const auto& [frame, message] : {std::pair{query_frame, query_status}, {stuffed_frame, stuffed_message}})
        for (std::size_t at = 0; at != frame.size(); ++at)
            for (unsigned bit = 0; bit != 8; ++bit) {
                auto changed = frame;
                changed[at] ^= std::byte{1} << bit;
                for (const auto& one : read_in_pieces<sae::jserial_reader>(changed, 64))
                    CHECK(one.find_first_not_of("0123456789abcdef ") != std::string::npos);
            }
}

TEST_CASE("the optional address of a serial frame is received") {
    // The checksums were computed with the function that the frames above confirm.
    std::uint16_t sum = sae::detail::first_checksum;
    auto head = from_hex("02 1400 3412");
    for (const auto b : head) sum = sae::detail::checksum(sum, b);
    auto inner = joined({{static_cast<std::byte>(sum & 0xFF), static_cast<std::byte>(sum >> 8)}, stuffed_message});
    std::uint16_t whole = sum;
    for (const auto b : inner) whole = sae::detail::checksum(whole, b);
    const auto doubled = [](const bytes& plain) {
        bytes out;
        for (const auto b : plain) out.insert(out.end(), b == std::byte{0x10} ? 2U : 1U, b);
        return out;
    };
    const auto frame = joined({from_hex("1001"), doubled(head), from_hex("1002"), doubled(inner), from_hex("1003"),
                               doubled({static_cast<std::byte>(whole & 0xFF), static_cast<std::byte>(whole >> 8)})});
    bytes buffer(64);
    sae::jserial_reader reader{buffer};
    int frames = 0;
    reader.on_bytes(frame, [&](const sae::serial_frame& f) {
        ++frames;
        CHECK(f);
        CHECK(f.address == std::array{std::byte{0x34}, std::byte{0x12}});
        CHECK(to_hex(f.message) == to_hex(stuffed_message));
    });
    CHECK(frames == 1);
}

TEST_CASE("a serial frame that is larger than the memory, or of another version, is refused") {
    CHECK(read_in_pieces<sae::jserial_reader>(stuffed_frame, 5, 19).front() == text(transport_errc::too_large));
    auto other = query_frame;
    other[2] = std::byte{1};
    CHECK(read_in_pieces<sae::jserial_reader>(other, 5).front() == text(transport_errc::wrong_version));
}
