// Reads from the categories of a slave's SII which SyncManagers carry process data, and how many bits.
#pragma once

#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/sii_read.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A SyncManager that carries process data.
struct process_manager {
    std::uint8_t number{};
    sii_sync_manager description{};
    std::uint32_t bits{};

    /// Whether the master writes them.
    [[nodiscard]] bool is_output() const noexcept { return description.use == sii_sync_manager_use::outputs; }
    [[nodiscard]] std::uint32_t bytes() const noexcept { return bits / 8 + (bits % 8 != 0 ? 1 : 0); }
};

/// State machine: `request` adds the datagram of the present step, `reply` takes its return. Stays in place while it
/// runs. Errors: those of sii_read, sii_malformed, too_many_managers.
class sii_survey {
  public:
    static constexpr std::size_t capacity = 4; ///< SyncManagers with process data

    sii_survey() noexcept = default;
    /// With `sizes` the PDOs are read, too: a datagram pair for each entry, so only where nothing else tells the sizes.
    explicit sii_survey(bool sizes) noexcept : sizes_{sizes} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    /// The SyncManagers that carry process data.
    [[nodiscard]] std::span<process_manager> managers() noexcept { return std::span{managers_}.first(count_); }
    /// The SyncManagers that carry process data.
    [[nodiscard]] std::span<const process_manager> managers() const noexcept {
        return std::span{managers_}.first(count_);
    }

    /// Starts with the first category.
    void begin() noexcept { read(step::category, sii_words::categories, wire::max_size<sii_category_header>); }

    void request(frame_builder& frame, std::uint16_t station) const noexcept { sii_.request(frame, station); }

    progress reply(const datagram_view& datagram, time_point now, const master_config& config) noexcept {
        const auto after = sii_.reply(datagram, now, config);
        if (after != progress::done) return after;
        if (result_ = sii_.result(); !result_) return progress::done;
        switch (step_) {
        case step::category: return category_read();
        case step::sync_manager: return sync_manager_read();
        case step::pdo: return pdo_read();
        default: return pdo_entry_read();
        }
    }

  private:
    enum class step : std::uint8_t { category, sync_manager, pdo, pdo_entry };

    static constexpr std::uint8_t max_managers = 32; // for which there are registers, and assignment objects
    static constexpr std::uint32_t sii_end = 0x8000; // words of the largest memory
    static constexpr unsigned max_categories = 100;  // an erased memory would have thousands
    static constexpr std::uint32_t manager_words = wire::max_size<sii_sync_manager> / 2;
    static constexpr std::uint32_t pdo_words = wire::max_size<sii_pdo> / 2;
    static constexpr std::uint32_t entry_words = wire::max_size<sii_pdo_entry> / 2;

    progress read(step next, std::uint32_t word, std::size_t bytes) noexcept {
        step_ = next;
        word_ = word;
        sii_ = sii_read{word, std::span{buffer_}.first(bytes)};
        return progress::send;
    }
    progress fail(const master_error& error) noexcept {
        result_ = error;
        return progress::done;
    }

    progress category_read() noexcept {
        sii_category_header header{};
        static_cast<void>(wire::decode_prefix(header, buffer_));
        const std::uint32_t content = word_ + wire::max_size<sii_category_header> / 2;
        end_ = content + header.words;
        switch (header.category) {
        case sii_category::end: return finish();
        case sii_category::sync_manager: return next_sync_manager(content);
        case sii_category::rx_pdo:
        case sii_category::tx_pdo: described_ = true; return sizes_ ? next_pdo(content) : next_category();
        default: return next_category();
        }
    }
    progress next_category() noexcept {
        if (++categories_ > max_categories || end_ >= sii_end)
            return fail({.code = master_errc::sii_malformed, .sii_word = end_});
        return read(step::category, end_, wire::max_size<sii_category_header>);
    }

    progress next_sync_manager(std::uint32_t word) noexcept {
        if (word + manager_words > end_) return next_category();
        return read(step::sync_manager, word, wire::max_size<sii_sync_manager>);
    }
    progress sync_manager_read() noexcept {
        if (number_ == max_managers) return fail({.code = master_errc::sii_malformed, .sii_word = word_});
        process_manager found{.number = number_++};
        static_cast<void>(wire::decode_prefix(found.description, buffer_));
        if (found.is_output() || found.description.use == sii_sync_manager_use::inputs) {
            if (count_ == capacity) return fail({.code = master_errc::too_many_managers});
            managers_[count_++] = found;
        }
        return next_sync_manager(word_ + manager_words);
    }

    // A PDO counts for the SyncManager that carries it from the start.
    progress next_pdo(std::uint32_t word) noexcept {
        return word + pdo_words <= end_ ? read(step::pdo, word, wire::max_size<sii_pdo>) : next_category();
    }
    progress pdo_read() noexcept {
        sii_pdo pdo{};
        static_cast<void>(wire::decode_prefix(pdo, buffer_));
        entries_left_ = pdo.entries;
        carrier_ = pdo.sync_manager;
        return next_pdo_entry(word_ + pdo_words);
    }
    progress next_pdo_entry(std::uint32_t word) noexcept {
        if (entries_left_ == 0) return next_pdo(word);
        if (word + entry_words > end_) return fail({.code = master_errc::sii_malformed, .sii_word = word});
        return read(step::pdo_entry, word, wire::max_size<sii_pdo_entry>);
    }
    progress pdo_entry_read() noexcept {
        sii_pdo_entry entry{};
        static_cast<void>(wire::decode_prefix(entry, buffer_));
        // The category of SyncManagers may come later: bits are kept by number.
        if (carrier_ < bits_.size()) bits_[carrier_] += entry.bits;
        --entries_left_;
        return next_pdo_entry(word_ + entry_words);
    }

    progress finish() noexcept {
        for (auto& each : managers()) {
            // Without a PDO the size is the SyncManager's default length.
            if (!described_)
                each.bits = each.description.length * 8u;
            else if (each.number < bits_.size())
                each.bits = bits_[each.number];
        }
        return progress::done;
    }

    bool sizes_{};
    step step_{};
    sii_read sii_{};
    std::array<std::byte, 8> buffer_{}; // the largest piece
    std::uint32_t word_{};              // where it stands
    std::uint32_t end_{};               // of the category
    unsigned categories_{};
    std::array<process_manager, capacity> managers_{};
    std::size_t count_{};
    std::uint8_t number_{}; // of the next SyncManager
    bool described_{};      // there are PDOs
    std::uint8_t carrier_{};
    std::uint32_t entries_left_{};
    std::array<std::uint32_t, 16> bits_{}; // of each SyncManager
    master_result<> result_{};
};

} // namespace jauscat::ethercat
