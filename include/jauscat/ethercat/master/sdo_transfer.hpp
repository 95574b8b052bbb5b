// SDO download or upload, master side: expedited, normal or segmented. mailbox_exchange handles the mailbox.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/reply_kind.hpp>
#include <jauscat/ethercat/master/sdo_options.hpp>
#include <jauscat/ethercat/sdo_segment.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// Transfer of one object: expedited, normal or in segments, as size and mailbox require. The data stay the caller's
/// until the transfer is done; what an upload that fails leaves in its buffer is not to be used.
class sdo_transfer {
  public:
    sdo_transfer() noexcept = default;

    /// Writes `data` into an entry, in as many segments as it takes. They must outlive the transfer.
    JAUSCAT_FUNCTION static sdo_transfer download(std::uint16_t index, std::uint8_t subindex,
                                                  std::span<const std::byte> data,
                                                  const download_options& options = {}) noexcept;
    /// Reads an entry `into` a buffer, in as many segments as it takes. It must outlive the transfer.
    JAUSCAT_FUNCTION static sdo_transfer upload(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> into,
                                                const upload_options& options = {}) noexcept;
    /// Abort of an unfinished transfer. It has no reply.
    JAUSCAT_FUNCTION static sdo_transfer abort(const sdo_abort& message) noexcept;

    /// The slave's mailbox takes messages of `size` bytes, mailbox header included: at least 24.
    void use_mailbox(std::size_t size) noexcept { room_ = size - wire::max_size<mailbox_header>; }

    /// Bytes received.
    [[nodiscard]] const master_result<std::size_t>& result() const noexcept { return result_; }
    /// The last answer has come; else the next request is due.
    [[nodiscard]] bool finished() const noexcept { return finished_; }
    [[nodiscard]] bool expects_answer() const noexcept { return request_ != sdo_specifier::abort; }
    /// The slave waits for more, or may do so: a transfer that is given up now has to be aborted.
    [[nodiscard]] JAUSCAT_FUNCTION bool is_open() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION sdo_abort abort_message() const noexcept;
    /// The command specifier of an answer to this object that did not answer the last request.
    [[nodiscard]] const std::optional<sdo_specifier>& unexpected() const noexcept { return unexpected_; }

    /// Bytes that `encode` writes.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t size() const noexcept;

    /// Writes the request, CoE header on, to the front of `out`, which holds at least `size()` bytes.
    JAUSCAT_FUNCTION void encode(std::span<std::byte> out) const noexcept;

    /// Takes a CoE message, CoE header on.
    JAUSCAT_FUNCTION reply_kind take(std::span<const std::byte> message) noexcept;

  private:
    enum class phase : std::uint8_t { initiate, clear, segments };

    static constexpr std::size_t initiate_overhead = wire::max_size<coe_header> + wire::max_size<sdo_normal>;
    static constexpr std::array<std::byte, 1> zero{};
    static constexpr std::size_t longest_unused = 65'536; // bytes of an object that are read only to reach its end

    sdo_transfer(sdo_specifier request, std::uint16_t index, std::uint8_t subindex) noexcept
        : request_{request}, index_{index}, subindex_{subindex} {}

    [[nodiscard]] bool is_download() const noexcept { return request_ == sdo_specifier::download_request; }
    [[nodiscard]] std::uint8_t subindex() const noexcept { return phase_ == phase::clear ? 0 : subindex_; }

    // Data of the initiate message.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<const std::byte> initial_data() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool is_expedited() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::span<const std::byte> next_segment() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION sdo_segment_header segment_header() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION sdo_specifier expected_response() const noexcept;

    JAUSCAT_FUNCTION reply_kind finish(const master_result<std::size_t>& result) noexcept;
    JAUSCAT_FUNCTION reply_kind aborted(abort_code code) noexcept;
    JAUSCAT_FUNCTION reply_kind next_request(phase next) noexcept;

    // The slave has confirmed what a download sent last.
    JAUSCAT_FUNCTION reply_kind go_on(bool cleared) noexcept;

    JAUSCAT_FUNCTION reply_kind take_upload(const sdo_header& header, std::span<const std::byte> sdo) noexcept;

    JAUSCAT_FUNCTION reply_kind take_segment(const sdo_segment_header& segment,
                                             std::span<const std::byte> sdo) noexcept;

    JAUSCAT_FUNCTION reply_kind mismatch(std::size_t last) noexcept; // bytes of the last part

    // Data of an upload, all of it or with more to follow. Unwanted data are read to the end as well: some slaves serve
    // nothing else before, even after an abort.
    JAUSCAT_FUNCTION reply_kind keep(std::span<const std::byte> data, bool more) noexcept;

    sdo_specifier request_{};
    std::uint16_t index_{};
    std::uint8_t subindex_{};
    bool empty_start_{};
    bool complete_access_{};
    abort_code code_{}; // of a request to abort
    std::span<const std::byte> data_{};
    std::span<std::byte> into_{};
    std::size_t room_ = max_mailbox_size - wire::max_size<mailbox_header>; // of a message, CoE header on

    phase phase_{};
    bool open_{}, finished_{};
    bool toggle_{};                              // of the next segment
    std::size_t done_{};                         // bytes of data that have been confirmed or received
    std::uint32_t announced_{};                  // by the slave: bytes of an upload in segments
    std::optional<std::size_t> expected_size_{}; // of an upload
    master_result<> spoilt_{};                   // ok, or why an upload is of no use
    std::optional<sdo_specifier> unexpected_{};
    master_result<std::size_t> result_{std::size_t{0}};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/sdo_transfer.ipp>
#endif
