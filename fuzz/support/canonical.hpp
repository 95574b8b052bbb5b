// What a message's bytes become when they are decoded and encoded again: the same bytes, but for the differences that
// the standards allow, which are named here.
#pragma once
#include "target.hpp"
#include <jauscat/wire/wire.hpp>

#include <cstdint>
#include <tuple>

namespace fuzz {

namespace detail {

class canonical_writer {
  public:
    explicit canonical_writer(std::span<const std::byte> in) : in_{in} {}

    template <class Layout> bool layout() {
        return Layout::all_items([&]<class Item>() { return item<Item>(); });
    }
    [[nodiscard]] bytes written() && { return std::move(out_); }

  private:
    template <class Item> bool item() {
        if constexpr (requires { Item::known_bits; })
            return presence<Item>();
        else if constexpr (requires { typename Item::inner; })
            return layout<typename Item::inner>();
        else if constexpr (requires { typename Item::carrier_type; })
            return bit_fields(Item{});
        else
            return keep<Item>();
    }

    template <class Item> bool keep() {
        static_assert(jauscat::wire::fixed_item<Item>, "canonical: say here which bytes this item may change");
        out_.insert(out_.end(), in_.begin(), in_.begin() + Item::max_size);
        in_ = in_.subspan(Item::max_size);
        return true;
    }

    // Allowed: reserved bits are ignored on receipt and sent as zero.
    template <class Carrier, class... Fields> bool bit_fields(jauscat::wire::bits<Carrier, Fields...>) {
        std::uint64_t named = 0;
        std::size_t at = 0;
        const auto name = [&](bool is_named, std::size_t width) {
            for (std::size_t bit = 0; bit != width; ++bit) named |= std::uint64_t{is_named} << (at + bit);
            at += width;
        };
        (name(Fields::keys::count != 0, Fields::width), ...);
        keep_masked<Carrier>(named);
        return true;
    }

    // Allowed: an open presence vector drops the bits it does not know, with all bytes to the end of the body.
    template <class Item> bool presence() {
        const auto announced = keep_masked<typename Item::carrier_codec>(Item::known_bits);
        std::size_t at = 0;
        const bool whole = Item::all_items([&]<class Sub>() {
            if constexpr (Sub::optional) {
                if ((announced >> at++ & 1u) == 0) return true;
            }
            return item<Sub>();
        });
        return whole && (announced & ~Item::known_bits) == 0;
    }

    template <class Carrier> std::uint64_t keep_masked(std::uint64_t mask) {
        using word_type = typename Carrier::value_type;
        word_type word{};
        static_cast<void>(Carrier::load(in_.data(), word));
        out_.resize(out_.size() + Carrier::size);
        static_cast<void>(
            Carrier::store(out_.data() + out_.size() - Carrier::size, static_cast<word_type>(word & mask)));
        in_ = in_.subspan(Carrier::size);
        return word;
    }

    std::span<const std::byte> in_;
    bytes out_;
};

} // namespace detail

/// `body` as a `T` that was decoded from it encodes. `body` is one that `wire::raw<T>` decodes.
template <jauscat::wire::message T> bytes canonical(std::span<const std::byte> body) {
    detail::canonical_writer writer{body};
    writer.layout<jauscat::wire::layout_of<T>>();
    return std::move(writer).written();
}

/// `message` encoded into memory of exactly its size.
template <jauscat::wire::message T> bytes encoded(const T& message) {
    bytes out(jauscat::wire::encoded_size(message));
    const auto size = jauscat::wire::encode(message, out);
    check(static_cast<bool>(size), "what decodes encodes");
    check(size.size() == out.size(), "encode writes encoded_size bytes");
    return out;
}

} // namespace fuzz
