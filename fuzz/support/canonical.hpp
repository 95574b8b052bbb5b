// What a message's bytes become when they are decoded and encoded again: the same bytes, but for the differences that
// the standards allow, which are named here.
#pragma once
#include "target.hpp"
#include <jauscat/wire/wire.hpp>

#include <optional>

namespace fuzz {

namespace detail {

/// Traces decoding and copies what it passes, byte by byte, changing only what `encode` may send otherwise.
class canonical_trace : public jauscat::wire::decode_trace {
  public:
    explicit canonical_trace(std::span<const std::byte> in) : decode_trace{in}, in_{in} {}

    template <class Item> void passed(const auto&) {
        const std::size_t start = out_.size();
        if constexpr (requires { Item::known_bits; }) {
            // Allowed: an open presence vector drops the bits it does not know, with all bytes to the end of the body.
            at_ = offset();
            mask<typename Item::carrier_codec>(vectors_.back(), Item::known_bits);
            vectors_.pop_back();
            return;
        }
        keep();
        // Allowed: reserved bits are ignored on receipt and sent as zero.
        if constexpr (requires { typename Item::fields; }) mask_reserved(Item{}, start);
        // Allowed: a string that is received in any length is sent in its own.
        if constexpr (sent_size<Item> != 0) {
            too_long_ = too_long_ ||
                        std::ranges::any_of(std::span{out_}.subspan(std::min(start + sent_size<Item>, out_.size())),
                                            [](std::byte b) { return b != std::byte{}; });
            out_.resize(start + sent_size<Item>);
        }
    }
    template <class> void passed_element(const auto&) { keep(); }
    template <std::size_t> void passed_number(std::string_view name, std::uint64_t) {
        if (name == "presence_vector") vectors_.push_back(out_.size());
        keep();
    }

    [[nodiscard]] std::optional<byte_vector> written() && {
        return too_long_ ? std::nullopt : std::optional{std::move(out_)};
    }

  private:
    template <class> static constexpr std::size_t sent_size = 0;
    template <auto Member, std::size_t Size>
    static constexpr std::size_t sent_size<jauscat::wire::lenient_run<Member, Size>> = Size;

    void keep() {
        const auto passed = in_.subspan(at_, offset() - at_);
        out_.insert(out_.end(), passed.begin(), passed.end());
        at_ += passed.size();
    }
    template <class Carrier> void mask(std::size_t start, std::uint64_t bits) {
        using word_type = typename Carrier::value_type;
        word_type word{};
        static_cast<void>(Carrier::load(out_.data() + start, word));
        static_cast<void>(Carrier::store(out_.data() + start, static_cast<word_type>(word & bits)));
    }
    template <class Carrier, class... Fields>
    void mask_reserved(jauscat::wire::bit_fields<Carrier, Fields...>, std::size_t start) {
        std::uint64_t named = 0;
        std::size_t at = 0;
        const auto name = [&](bool is_named, std::size_t width) {
            for (std::size_t bit = 0; bit != width; ++bit) named |= std::uint64_t{is_named} << (at + bit);
            at += width;
        };
        (name(Fields::keys::count != 0, Fields::width), ...);
        mask<Carrier>(start, named);
    }

    std::span<const std::byte> in_;
    std::size_t at_{};
    byte_vector out_;
    std::vector<std::size_t> vectors_; ///< where the presence vectors stand that decoding is inside of
    bool too_long_{};
};

} // namespace detail

/// `body` as a `T` that was decoded from it encodes; nothing where it holds a string that is longer than may be sent.
/// `body` is one that `wire::raw<T>` decodes.
template <jauscat::wire::message T> std::optional<byte_vector> canonical(std::span<const std::byte> body) {
    namespace wire = jauscat::wire;
    wire::raw<T> scratch{};
    detail::canonical_trace trace{body};
    check(wire::decode_traced(scratch, trace), "a traced decode finds what decode finds");
    return std::move(trace).written();
}

/// `message` encoded into memory of exactly its size; nothing where its string is longer than may be sent.
template <jauscat::wire::message T> std::optional<byte_vector> encoded(const T& message) {
    byte_vector out(jauscat::wire::encoded_size(message));
    const auto written = jauscat::wire::encode(message, out);
    if (written.error() == jauscat::wire::errc::out_of_range) return {};
    check(static_cast<bool>(written), "what decodes encodes");
    check(written->size() == out.size(), "encode writes encoded_size bytes");
    return out;
}

} // namespace fuzz
