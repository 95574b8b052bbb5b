// Finds out what process data a slave has, and sets its SyncManagers and FMMUs up for them. Where the slave says so
// over CoE (PDO assignment 1C10h + SyncManager, PDO mapping objects) that counts, else its SII.
#pragma once

#include <jauscat/ethercat/activity.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/process_image.hpp>
#include <jauscat/ethercat/sdo_transfer.hpp>
#include <jauscat/ethercat/sii_read.hpp>
#include <jauscat/ethercat/slave_record.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// State machine: while `wants_upload`, run `upload()` and pass its outcome to `uploaded`; else `request` adds the
/// datagrams of the present step and `reply` takes their return. Stays in place while it runs.
class process_setup {
  public:
    process_setup() noexcept = default;
    /// `slave` is in PRE-OP. `image` is that of all other slaves: this one's place follows.
    process_setup(const slave_record& slave, const process_image& image) noexcept
        : station_{slave.station},
          coe_{slave.mailbox.coe && slave.mailbox.receive_size != 0},
          before_{slave.process_data},
          image_{image} {}

    [[nodiscard]] const outcome& result() const noexcept { return result_; }
    /// Where the slave's process data are; once it is done.
    [[nodiscard]] const process_place& place() const noexcept { return place_; }

    [[nodiscard]] bool wants_upload() const noexcept { return step_ == step::assignment || step_ == step::mapping; }
    [[nodiscard]] sdo_transfer upload() noexcept {
        if (step_ == step::assignment)
            return sdo_transfer::upload(static_cast<std::uint16_t>(0x1C10 + managers_[manager_].number),
                                        static_cast<std::uint8_t>(pdo_), value_);
        return sdo_transfer::upload(mapping_, static_cast<std::uint8_t>(entry_), value_);
    }
    progress uploaded(const outcome& upload) noexcept {
        // Without assignment objects the SII counts, as for a slave without CoE.
        if (upload.error == master_errc::sdo_abort && step_ == step::assignment && pdo_ == 0) return survey_done(false);
        if (!upload) return fail(upload.error, upload.detail);
        if (step_ == step::assignment) return assigned(number_of(upload.size));
        return mapped(number_of(upload.size));
    }

    void request(frame_builder& frame) noexcept {
        const auto write = [&](esc_register r, const auto& value) {
            frame.add(command::fpwr, station_, r.address, value);
        };
        switch (step_) {
        case step::describe:
            frame.add(command::fprd, station_, esc_registers::type.address, wire::max_size<esc_description>);
            break;
        case step::take_sii: // by force, then without
            write(esc_registers::sii_owner, sii_owner{.force = true});
            write(esc_registers::sii_owner, sii_owner{});
            break;
        case step::give_sii: write(esc_registers::sii_owner, sii_owner{.pdi = true}); break;
        case step::set_up: set_up(frame); break;
        default: sii_.request(frame, station_);
        }
    }

    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        for (const auto& datagram : datagrams) {
            if (datagram.working_counter > 1) return fail(master_errc::duplicate_station, datagram.working_counter);
            if (datagram.working_counter == 0) return fail(master_errc::working_counter);
        }
        switch (step_) {
        case step::describe: {
            esc_description controller{};
            static_cast<void>(wire::decode(controller, datagrams.front().data));
            fmmus_ = controller.fmmus;
            place_.no_lrw = controller.no_lrw;
            return go(step::take_sii);
        }
        case step::take_sii: return read(step::category, sii_words::categories, wire::max_size<sii_category_header>);
        case step::give_sii: return lay_out();
        case step::set_up: return progress::done;
        default: break;
        }
        const auto after = sii_.reply(datagrams.front(), now, config);
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
    enum class step : std::uint8_t {
        describe,
        take_sii,
        category,     // the head of a category of the SII
        sync_manager, // an entry of category SyncM
        assignment,   // CoE: which PDOs a SyncManager carries
        mapping,      // CoE: what a PDO is made of
        pdo,          // the head of a PDO in the SII
        pdo_entry,
        give_sii,
        set_up,
    };

    /// A SyncManager with process data.
    struct manager {
        std::uint8_t number{};
        sii_sync_manager description{};
        std::uint32_t bits{};
        [[nodiscard]] bool outputs() const noexcept { return description.use == sii_sync_manager_use::outputs; }
        [[nodiscard]] std::uint16_t bytes() const noexcept { return static_cast<std::uint16_t>((bits + 7) / 8); }
    };
    /// Categories TxPDO or RxPDO of the SII.
    struct pdo_category {
        std::uint32_t word{}, end{};
    };
    static constexpr std::size_t capacity = 4;
    static constexpr std::size_t max_fmmus = 16;
    static constexpr std::uint32_t sii_end = 0x8000; // words of the largest memory
    static constexpr unsigned max_categories = 100;  // an erased memory would have thousands

    progress go(step next) noexcept {
        step_ = next;
        return progress::send;
    }
    progress fail(master_errc error, std::uint32_t detail = 0) noexcept {
        result_ = {.error = error, .detail = detail};
        return progress::done;
    }
    progress read(step next, std::uint32_t word, std::size_t bytes) noexcept {
        word_ = word;
        sii_ = sii_read{word, std::span{buffer_}.first(bytes)};
        return go(next);
    }
    progress next_category() noexcept {
        if (++categories_ > max_categories || category_end_ >= sii_end)
            return fail(master_errc::sii_malformed, category_end_);
        return read(step::category, category_end_, wire::max_size<sii_category_header>);
    }

    progress category_read() noexcept {
        sii_category_header header{};
        static_cast<void>(wire::decode_prefix(header, buffer_));
        const std::uint32_t content = word_ + wire::max_size<sii_category_header> / 2;
        category_end_ = content + header.words;
        switch (header.category) {
        case sii_category::end: return coe_ ? survey() : survey_done(false);
        case sii_category::sync_manager: return next_sync_manager(content);
        case sii_category::rx_pdo: pdos_[0] = {content, category_end_}; break;
        case sii_category::tx_pdo: pdos_[1] = {content, category_end_}; break;
        default: break;
        }
        return next_category();
    }

    progress next_sync_manager(std::uint32_t word) noexcept {
        constexpr auto words = wire::max_size<sii_sync_manager> / 2;
        return word + words <= category_end_ ? read(step::sync_manager, word, wire::max_size<sii_sync_manager>)
                                             : next_category();
    }
    progress sync_manager_read() noexcept {
        manager found{.number = number_++};
        static_cast<void>(wire::decode_prefix(found.description, buffer_));
        using enum sii_sync_manager_use;
        if (found.description.use == outputs || found.description.use == inputs) {
            if (count_ == capacity) return fail(master_errc::too_many_managers);
            managers_[count_++] = found;
        }
        return next_sync_manager(word_ + wire::max_size<sii_sync_manager> / 2);
    }

    // CoE: every PDO of every SyncManager, and every entry of every PDO.
    progress survey() noexcept {
        if (manager_ == count_) return survey_done(true);
        pdo_ = 0;
        return go(step::assignment);
    }
    progress assigned(std::uint32_t value) noexcept {
        if (pdo_ == 0) {
            pdos_left_ = value;
        } else {
            mapping_ = static_cast<std::uint16_t>(value);
            entry_ = 0;
            if (mapping_ != 0) return go(step::mapping); // 0: a place that is not used
        }
        return next_pdo();
    }
    progress next_pdo() noexcept {
        if (pdo_++ != pdos_left_) return go(step::assignment);
        ++manager_;
        return survey();
    }
    progress mapped(std::uint32_t value) noexcept {
        if (entry_ == 0)
            entries_left_ = value;
        else
            managers_[manager_].bits += value & 0xFF; // index, subindex and, in the low byte, bits
        if (entry_++ != entries_left_) return go(step::mapping);
        return next_pdo();
    }
    [[nodiscard]] std::uint32_t number_of(std::size_t size) const noexcept {
        std::uint32_t number = 0;
        for (std::size_t i = std::min(size, value_.size()); i-- != 0;)
            number = number << 8 | std::to_integer<std::uint32_t>(value_[i]);
        return number;
    }

    // The SII: the PDOs that say which SyncManager carries them from the start.
    progress survey_done(bool by_coe) noexcept {
        if (by_coe) return go(step::give_sii);
        for (auto& each : std::span{managers_}.first(count_)) each.bits = 0;
        category_ = 0;
        return next_pdo_category();
    }
    progress next_pdo_category() noexcept {
        while (category_ != pdos_.size() && pdos_[category_].word == pdos_[category_].end) ++category_;
        if (category_ != pdos_.size()) return read(step::pdo, pdos_[category_].word, wire::max_size<sii_pdo>);
        // What no PDO describes is as long as the SyncManager is from the start.
        const bool described = pdos_[0].end != 0 || pdos_[1].end != 0;
        for (auto& each : std::span{managers_}.first(count_))
            if (!described) each.bits = each.description.length * 8u;
        return go(step::give_sii);
    }
    progress pdo_read() noexcept {
        sii_pdo pdo{};
        static_cast<void>(wire::decode_prefix(pdo, buffer_));
        entries_left_ = pdo.entries;
        sync_manager_ = pdo.sync_manager;
        return next_pdo_entry(word_ + wire::max_size<sii_pdo> / 2);
    }
    progress pdo_entry_read() noexcept {
        sii_pdo_entry entry{};
        static_cast<void>(wire::decode_prefix(entry, buffer_));
        for (auto& each : std::span{managers_}.first(count_))
            if (each.number == sync_manager_) each.bits += entry.bits;
        --entries_left_;
        return next_pdo_entry(word_ + wire::max_size<sii_pdo_entry> / 2);
    }
    progress next_pdo_entry(std::uint32_t word) noexcept {
        const auto end = pdos_[category_].end;
        if (word + (entries_left_ != 0 ? 4u : 0u) > end) return fail(master_errc::sii_malformed, word);
        if (entries_left_ != 0) return read(step::pdo_entry, word, wire::max_size<sii_pdo_entry>);
        if (word + 4u <= end) return read(step::pdo, word, wire::max_size<sii_pdo>);
        ++category_;
        return next_pdo_category();
    }

    progress lay_out() noexcept {
        std::uint32_t outputs = 0, inputs = 0, used = 0;
        for (const auto& each : std::span{managers_}.first(count_)) {
            if (each.bits == 0) continue;
            (each.outputs() ? outputs : inputs) += each.bytes();
            ++(each.outputs() ? place_.output_managers : place_.input_managers);
            ++used;
        }
        if (used > fmmus_) return fail(master_errc::no_fmmu, used);
        // A slave that comes back keeps its place.
        const bool same = outputs == before_.output_size && inputs == before_.input_size && before_.size() != 0;
        place_.output_address = same ? before_.output_address : static_cast<std::uint32_t>(image_.size);
        const bool two_datagrams = place_.no_lrw || image_.no_lrw;
        const std::size_t end = std::max(image_.size, std::size_t{place_.output_address} + outputs + inputs);
        if (end > (two_datagrams ? max_process_image_without_lrw : max_process_image))
            return fail(master_errc::image_full, outputs + inputs);
        place_.input_address = place_.output_address + outputs;
        place_.output_size = static_cast<std::uint16_t>(outputs);
        place_.input_size = static_cast<std::uint16_t>(inputs);
        return fmmus_ == 0 && count_ == 0 ? progress::done : go(step::set_up);
    }

    // All in one frame. A SyncManager can be changed only while it is off.
    void set_up(frame_builder& frame) const noexcept {
        auto output = place_.output_address, input = place_.input_address;
        std::size_t fmmus = 0;
        // None is left from before.
        if (fmmus_ != 0)
            frame.add(command::fpwr, station_, esc_registers::fmmu.address,
                      std::min<std::size_t>(fmmus_, max_fmmus) * esc_registers::fmmu.size);
        for (const auto& each : std::span{managers_}.first(count_)) {
            const auto register_of = [](esc_register first, std::size_t n) {
                return static_cast<std::uint16_t>(first.address + n * first.size);
            };
            std::array<std::byte, wire::max_size<sync_manager>> bytes{};
            bytes[4] = static_cast<std::byte>(each.description.control);
            sync_manager settings{};
            static_cast<void>(wire::decode(settings, bytes));
            settings.start = each.description.start;
            settings.length = each.bytes();
            const auto at = register_of(esc_registers::sync_manager, each.number);
            frame.add(command::fpwr, station_, at, settings);
            settings.enable = each.bits != 0;
            if (!settings.enable) continue;
            frame.add(command::fpwr, station_, at, settings);
            auto& address = each.outputs() ? output : input;
            frame.add(command::fpwr, station_, register_of(esc_registers::fmmu, fmmus++),
                      fmmu{.logical_start = address,
                           .length = each.bytes(),
                           .last_bit = 7,
                           .physical_start = each.description.start,
                           .read = !each.outputs(),
                           .write = each.outputs(),
                           .enable = true});
            address += each.bytes();
        }
    }

    std::uint16_t station_{};
    bool coe_{};
    process_place before_{}, place_{};
    process_image image_{};
    std::uint8_t fmmus_{};
    step step_{};

    sii_read sii_{};
    std::array<std::byte, 8> buffer_{}; // of what is read of the SII: the largest piece
    std::uint32_t word_{};              // where it stands
    std::uint32_t category_end_{};
    unsigned categories_{};
    std::array<pdo_category, 2> pdos_{}; // outputs, inputs
    std::size_t category_{};             // of the two
    std::uint8_t sync_manager_{};        // of the PDO in the SII

    std::array<manager, capacity> managers_{};
    std::size_t count_{};
    std::uint8_t number_{};
    std::size_t manager_{}; // whose assignment is read

    std::array<std::byte, 4> value_{}; // of an object
    std::uint32_t pdo_{}, pdos_left_{}, entry_{}, entries_left_{};
    std::uint16_t mapping_{};
    outcome result_{};
};

} // namespace jauscat::ethercat
