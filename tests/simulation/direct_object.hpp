// An object of a slave that only the direct user of the master transfers. Its value says which transfer it belongs to.
#pragma once

#include "simulation/generator.hpp"
#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

namespace simulation {

namespace ethercat = jauscat::ethercat;

/// In front of the objects of an application. Models described_object_source; the object itself is not described.
class direct_object {
  public:
    static constexpr std::uint16_t index = 0x3F00;
    /// Words of 8 bytes in each entry, from subindex 1: the second one takes segments.
    static constexpr std::array<std::size_t, 2> words{1, 40};
    static constexpr std::size_t longest = 8 * 40;
    using word = std::uint64_t;

    /// `application` and `now`, the time of the slave, must outlive this.
    direct_object(ethercat::object_dictionary application, std::uint32_t serial, const time& now) noexcept
        : application_{application}, serial_{serial}, now_{now} {}

    /// What the slave with this serial number answers at that time.
    [[nodiscard]] static word answer(std::uint32_t serial, std::uint8_t subindex, time at) noexcept {
        return static_cast<word>(at.count()) << 16U | word{serial & 0xFFU} << 8U | subindex;
    }
    [[nodiscard]] static time time_of(word answer) noexcept { return time{static_cast<std::int64_t>(answer >> 16U)}; }
    static void fill(std::span<std::byte> out, word value) noexcept {
        for (std::size_t i = 0; i + sizeof value <= out.size(); i += sizeof value)
            std::memcpy(&out[i], &value, sizeof value);
    }
    /// The word of which an entry of this subindex consists; none where it does not.
    [[nodiscard]] static std::optional<word> value_of(std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        if (subindex == 0 || subindex > words.size() || data.size() != sizeof(word) * words[subindex - 1U]) return {};
        word first{};
        std::memcpy(&first, data.data(), sizeof first);
        for (std::size_t i = 0; i != data.size(); i += sizeof first)
            if (std::memcmp(&data[i], &first, sizeof first) != 0) return {};
        return first;
    }
    /// The last value that was written.
    [[nodiscard]] const std::optional<word>& written() const noexcept { return written_; }

    /// Of the objects of the application.
    [[nodiscard]] ethercat::abort_code last_abort() const noexcept { return last_abort_; }

    ethercat::object_read read(std::uint16_t of, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        if (of != index) {
            const auto got = application_.read(of, subindex, out);
            if (got.error != ethercat::abort_code::none) last_abort_ = got.error;
            return got;
        }
        if (subindex == 0 || subindex > words.size()) return {.error = ethercat::abort_code::no_subindex};
        const std::size_t size = sizeof(word) * words[subindex - 1U];
        if (out.size() < size) return {.error = ethercat::abort_code::exceeds_mailbox};
        fill(out.first(size), answer(serial_, subindex, now_));
        return {.size = size};
    }
    ethercat::abort_code write(std::uint16_t of, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        if (of != index) {
            const auto got = application_.write(of, subindex, data);
            if (got != ethercat::abort_code::none) last_abort_ = got;
            return got;
        }
        const auto value = value_of(subindex, data);
        if (!value) return ethercat::abort_code::value_range;
        written_ = value;
        return ethercat::abort_code::none;
    }
    [[nodiscard]] bool is_described() const noexcept { return application_.is_described(); }
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        return application_.next_index(after);
    }
    [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t of) const noexcept {
        return application_.describe(of);
    }
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t of, std::uint8_t sub) const noexcept {
        return application_.describe(of, sub);
    }

  private:
    ethercat::object_dictionary application_;
    std::uint32_t serial_;
    const time& now_;
    std::optional<word> written_{};
    ethercat::abort_code last_abort_{};
};

} // namespace simulation
