// Process data of a slave that are a process image by tables: one command into its outputs, one report from its inputs.
#pragma once
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/jaus/message/all_zero.hpp>
#include <jauscat/jaus/message/message.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// An image_table into a slave's outputs that counts commands.
template <class T>
concept command_table = requires {
    typename T::image_type;
    typename T::counter_row::counts_messages;
} && jaus::coded_message<typename T::message_type>;

/// An image_table from a slave's inputs whose message answers a query.
template <class T>
concept report_table = requires { typename T::image_type; } && jaus::report_message<typename T::message_type>;

namespace detail {

template <class Commands, class Reports> consteval bool are_image_tables() noexcept {
    static_assert(command_table<Commands>,
                  "image_part: the first table is an image_table of a command, with a row counter for the outputs");
    static_assert(report_table<Reports>,
                  "image_part: the second table is an image_table of a report that answers a query, for the inputs");
    return command_table<Commands> && report_table<Reports>;
}

template <class Commands, class Reports, bool = are_image_tables<Commands, Reports>()> class image_part_of {};

template <class Commands, class Reports> class image_part_of<Commands, Reports, true> : public process_part {
    using exchange = image_exchange<Commands, Reports>;
    using command_type = typename Commands::message_type;
    using query_type = jaus::query_of<typename Reports::message_type>;

  public:
    /// `at_rest` is the command that brings the actuator to rest; by default all its fields are zero.
    explicit image_part_of(const command_type& at_rest = jaus::all_zero<command_type>()) noexcept {
        if (const auto encoded = wire::encode(at_rest, rest_)) rest_size_ = encoded->size();
    }

    [[nodiscard]] result<void, translate::errc> start(slave_group slaves, duration) override {
        if (slaves.size() != 1) return translate::errc::wrong_size;
        const auto& slave = slaves.front();
        if (const auto started = exchange_.start(slave.outputs, slave.inputs); !started) return started;
        std::array<std::byte, exchange::command::image_size> image{};
        std::ranges::copy(slave.outputs, image.begin());
        number_ = exchange::taken(slave.inputs);
        return exchange::command::to_image(rest(), image);
    }
    [[nodiscard]] bool takes(std::uint16_t command_code) const override {
        return command_code == exchange::command_code || command_code == exchange::query_code;
    }
    [[nodiscard]] bool uses_mailbox() const override { return true; }

    [[nodiscard]] result<std::uint32_t, translate::errc>
    command(const jaus::header& head, std::span<const std::byte> body, slave_group slaves, time_point now) override {
        jaus::header plain = head;
        plain.ack_nak = jaus::ack_nak::none; // acknowledged by the component
        const auto& slave = slaves.front();
        if (const auto done = exchange_.on_command(plain, body, slave.outputs, slave.inputs, now); !done)
            return done.error();
        number_ += static_cast<counter>(exchange::given(slave.outputs) - static_cast<counter>(number_));
        return number_;
    }
    [[nodiscard]] bool merges_next(slave_group slaves) const override {
        return exchange::merges_next(slaves.front().outputs, slaves.front().inputs);
    }
    std::uint32_t stop(stop_order, slave_group slaves) override {
        if (slaves.front().outputs.empty()) return number_;
        return command({}, rest(), slaves, {}).value_or(number_); // `start` has tried it
    }
    [[nodiscard]] std::uint32_t executed(slave_group slaves) const override {
        const auto taken = exchange::taken(slaves.front().inputs);
        return number_ - static_cast<counter>(static_cast<counter>(number_) - taken);
    }
    [[nodiscard]] result<std::span<std::byte>, translate::errc> answer(const jaus::header& query,
                                                                       std::span<const std::byte> body,
                                                                       slave_group slaves,
                                                                       std::span<std::byte> out) const override {
        return exchange_.template on_query<query_type>(query, body, slaves.front().inputs, out);
    }
    std::optional<drive_fault> step(slave_group, time_point) override { return std::nullopt; }
    void reset() override {}

  private:
    using counter = typename exchange::counter;

    [[nodiscard]] std::span<const std::byte> rest() const noexcept { return std::span{rest_}.first(rest_size_); }

    exchange exchange_{{}, {}}; // messages have the component's own address
    std::array<std::byte, wire::max_size<command_type>> rest_{};
    std::size_t rest_size_{};
    std::uint32_t number_{}; ///< of the last command; its low bits are the counter in the outputs
};

} // namespace detail

/// Carries the commands and queries of two tables by the process data of one slave that has JAUS objects as well: what
/// the tables do not name goes by its mailbox. `Commands` is an image_table into the outputs that counts commands,
/// `Reports` one from the inputs that repeats the counter of the last command executed; see image_exchange.
template <class Commands, class Reports> class image_part final : public detail::image_part_of<Commands, Reports> {
    using detail::image_part_of<Commands, Reports>::image_part_of;
};

} // namespace jauscat::bridging
