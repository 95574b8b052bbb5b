// One SDO download or upload as the master sees it: requests out, answers in. The mailbox around it is
// mailbox_exchange's.
#pragma once

#include <jauscat/ethercat/activity.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// Bytes of mailbox, CoE and SDO header before the data of a transfer.
inline constexpr std::uint32_t sdo_overhead =
    wire::max_size<mailbox_header> + wire::max_size<coe_header> + wire::max_size<sdo_normal>;

/// What a mailbox message meant to the protocol that waits for it.
enum class mail : std::uint8_t {
    other, ///< not the answer: keep waiting
    final, ///< the last answer: see the outcome
};

/// Expedited or normal transfer of one object. The data stay the caller's until the transfer is done.
class sdo_transfer {
  public:
    sdo_transfer() noexcept = default;

    static sdo_transfer download(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        sdo_transfer transfer{sdo_specifier::download_request, index, subindex};
        transfer.data_ = data;
        return transfer;
    }
    static sdo_transfer upload(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> into) noexcept {
        sdo_transfer transfer{sdo_specifier::upload_request, index, subindex};
        transfer.into_ = into;
        return transfer;
    }

    [[nodiscard]] const outcome& result() const noexcept { return result_; }
    /// The last emergency that arrived in between.
    [[nodiscard]] const std::optional<coe_emergency>& emergency() const noexcept { return emergency_; }
    /// The command specifier of an answer to this object that did not answer this request.
    [[nodiscard]] const std::optional<sdo_specifier>& unexpected() const noexcept { return unexpected_; }

    /// Bytes that `encode` writes.
    [[nodiscard]] std::size_t size() const noexcept {
        return wire::max_size<coe_header> + wire::max_size<sdo_normal> + (is_expedited() ? 0 : data_.size());
    }

    /// Writes the request, CoE header on, to the front of `out`, which holds at least `size()` bytes.
    void encode(std::span<std::byte> out) const noexcept {
        out = out.subspan(wire::encode(coe_header{.service = coe_service::sdo_request}, out).size());
        sdo_header header{.specifier = request_, .index = index_, .subindex = subindex_};
        header.size_indicated = request_ == sdo_specifier::download_request;
        if (is_expedited()) {
            sdo_expedited sdo{.header = header};
            sdo.header.expedited = true;
            sdo.header.unused = static_cast<std::uint8_t>(sdo.data.size() - data_.size());
            std::ranges::copy(data_, sdo.data.begin());
            static_cast<void>(wire::encode(sdo, out));
        } else {
            const auto used = wire::encode(sdo_normal{header, static_cast<std::uint32_t>(data_.size())}, out);
            std::ranges::copy(data_, out.subspan(used.size()).begin());
        }
    }

    /// Takes a CoE message, CoE header on.
    mail take(std::span<const std::byte> message) noexcept {
        coe_header coe{};
        const auto sdo = message.subspan(wire::decode_prefix(coe, message).size());
        if (coe.service == coe_service::emergency) {
            coe_emergency emergency{};
            if (wire::decode_prefix(emergency, sdo)) emergency_ = emergency;
            return mail::other;
        }
        sdo_abort abort{};
        const auto used = wire::decode_prefix(abort, sdo);
        const bool is_sdo = coe.service == coe_service::sdo_response || coe.service == coe_service::sdo_request;
        if (!used || !is_sdo) return mail::other;
        const auto& header = abort.header;
        if (header.index != index_ || header.subindex != subindex_) return mail::other;
        // Slaves abort with the service of a request or of a response, and leave other bits of the command as they
        // were.
        if (header.specifier == sdo_specifier::abort)
            return finish({.error = master_errc::sdo_abort, .detail = static_cast<std::uint32_t>(abort.code)});
        if (coe.service == coe_service::sdo_response && header.specifier == expected_response()) {
            return request_ == sdo_specifier::download_request ? finish({}) : take_upload(header, sdo);
        }
        unexpected_ = header.specifier;
        return mail::other;
    }

  private:
    sdo_transfer(sdo_specifier request, std::uint16_t index, std::uint8_t subindex) noexcept
        : request_{request}, index_{index}, subindex_{subindex} {}

    [[nodiscard]] bool is_expedited() const noexcept {
        return request_ == sdo_specifier::download_request && !data_.empty() &&
               data_.size() <= wire::max_size<sdo_expedited> - wire::max_size<sdo_header>;
    }
    [[nodiscard]] sdo_specifier expected_response() const noexcept {
        return request_ == sdo_specifier::download_request ? sdo_specifier::download_response
                                                           : sdo_specifier::upload_response;
    }

    mail finish(const outcome& result) noexcept {
        result_ = result;
        return mail::final;
    }

    mail take_upload(const sdo_header& header, std::span<const std::byte> sdo) noexcept {
        if (header.expedited) {
            sdo_expedited expedited{};
            static_cast<void>(wire::decode_prefix(expedited, sdo));
            const std::size_t unused = header.size_indicated ? header.unused : 0u;
            return keep(std::span{expedited.data}.first(expedited.data.size() - unused));
        }
        sdo_normal normal{};
        const auto data = sdo.subspan(wire::decode_prefix(normal, sdo).size());
        if (header.size_indicated && normal.size != data.size())
            return finish({.error = master_errc::size_mismatch, .detail = normal.size});
        return keep(data);
    }

    mail keep(std::span<const std::byte> data) noexcept {
        if (data.size() > into_.size())
            return finish({.error = master_errc::data_too_long, .detail = static_cast<std::uint32_t>(into_.size())});
        std::ranges::copy(data, into_.begin());
        return finish({.size = data.size()});
    }

    sdo_specifier request_{};
    std::uint16_t index_{};
    std::uint8_t subindex_{};
    std::span<const std::byte> data_{};
    std::span<std::byte> into_{};
    std::optional<coe_emergency> emergency_{};
    std::optional<sdo_specifier> unexpected_{};
    outcome result_{};
};

} // namespace jauscat::ethercat
