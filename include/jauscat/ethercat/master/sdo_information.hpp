// SDO information, master side: object list, object description, entry description. The response may have several
// fragments; mailbox_exchange handles the mailbox.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/reply_kind.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// One request and the fragments of its response, whose data are put together in a buffer of the caller's.
class sdo_information {
  public:
    sdo_information() noexcept = default;

    /// The indices of the objects in a list, 2 bytes each.
    JAUSCAT_FUNCTION static sdo_information list(object_list_type type, std::span<std::byte> into) noexcept;
    /// An object's object_answer and name.
    JAUSCAT_FUNCTION static sdo_information object(std::uint16_t index, std::span<std::byte> into) noexcept;
    /// An entry's entry_answer, values and name.
    JAUSCAT_FUNCTION static sdo_information entry(const entry_query& entry, std::span<std::byte> into) noexcept;

    /// Bytes received.
    [[nodiscard]] const master_result<std::size_t>& result() const noexcept { return result_; }
    [[nodiscard]] static constexpr bool expects_answer() noexcept { return true; }
    /// Nothing here is kept track of: other answers are passed over.
    [[nodiscard]] static constexpr std::optional<sdo_specifier> unexpected() noexcept { return {}; }
    /// Bytes that `encode` writes.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t size() const noexcept;
    /// Writes the request, CoE header on, to the front of `out`, which holds at least `size()` bytes.
    JAUSCAT_FUNCTION void encode(std::span<std::byte> out) const noexcept;

    /// Takes a CoE message, CoE header on.
    JAUSCAT_FUNCTION reply_kind take(std::span<const std::byte> message) noexcept;

  private:
    static constexpr std::size_t name_size = 3; // index and subindex

    sdo_information(sdo_information_opcode request, std::span<std::byte> into) noexcept
        : request_{request}, into_{into} {}

    template <wire::message T> void put(const T& question) noexcept {
        size_ = wire::encode(question, question_)->size();
    }

    // The smallest mailbox carries 12 bytes in a fragment; empty ones would take hours.
    [[nodiscard]] std::size_t most_fragments() const noexcept { return 2 + into_.size() / 8; }
    JAUSCAT_FUNCTION reply_kind refused(std::span<const std::byte> message) noexcept;
    JAUSCAT_FUNCTION reply_kind finish(const master_result<std::size_t>& result) noexcept;

    sdo_information_opcode request_{};
    std::array<std::byte, wire::max_size<entry_query>> question_{};
    std::size_t size_{};     // of the question
    std::size_t repeated_{}; // bytes of the question that the first fragment repeats and the caller does not want
    std::span<std::byte> into_{};
    std::size_t done_{};   // bytes that have come
    std::uint32_t left_{}; // fragments
    bool begun_{};
    master_result<std::size_t> result_{std::size_t{0}};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/sdo_information.ipp>
#endif
