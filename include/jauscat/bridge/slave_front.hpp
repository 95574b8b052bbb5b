// Interface between a slave and its components: presence, queued messages, the one on its way.
#pragma once
#include <jauscat/bridge/any_exchange.hpp>
#include <jauscat/bridge/bridge_options.hpp>
#include <jauscat/bridge/observer.hpp>
#include <jauscat/bridge/order_queue.hpp>
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/jaus/message/hook.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// Components that one slave can have.
inline constexpr std::size_t component_capacity = 8;

/// Between the components in front of a slave and the ring that reaches it. Both refer to it.
class slave_front {
  public:
    /// The exchange, made for the same slave identity, the options of the bridge, the memory and the functions of the
    /// observer must outlive this.
    template <std::size_t Orders, std::size_t Size>
    slave_front(const slave_options& options, any_exchange& exchange, const bridge_options& timing,
                order_memory<Orders, Size>& memory, const observer& watcher) noexcept
        : options_{options}, exchange_{exchange}, timing_{timing}, watcher_{watcher}, orders_{memory} {}
    slave_front(const slave_front&) = delete;
    slave_front& operator=(const slave_front&) = delete;

    [[nodiscard]] const slave_options& options() const noexcept { return options_; }
    [[nodiscard]] const bridge_options& timing() const noexcept { return timing_; }
    [[nodiscard]] std::uint16_t station() const noexcept { return options_.identity.station; }
    /// Whether the slave answers and takes messages.
    [[nodiscard]] bool up() const noexcept { return up_; }
    void set_up(bool up) noexcept { up_ = up; }
    /// Process data of a cyclic slave that is up.
    [[nodiscard]] const slave_data& data() const noexcept { return data_; }
    void set_data(const slave_data& data) noexcept { data_ = data; }

    /// Where the slave was found, before the ring has the front.
    void place_at(std::uint16_t position, const ethercat::identity_check& expected) noexcept {
        options_.position = position;
        options_.expected = expected;
    }

    [[nodiscard]] any_exchange& exchange() const noexcept { return exchange_; }
    [[nodiscard]] const observer& watcher() const noexcept { return watcher_; }
    [[nodiscard]] order_queue& orders() noexcept { return orders_; }
    [[nodiscard]] const order_queue& orders() const noexcept { return orders_; }
    /// The message that has left the queue for the slave's mailbox, until the slave has answered.
    [[nodiscard]] const std::optional<order>& carried() const noexcept { return carried_; }
    void set_carried(const std::optional<order>& message) noexcept {
        carried_ = message;
        is_withdrawn_ = false;
    }
    /// It is not to be sent any more.
    void withdraw_carried() noexcept { is_withdrawn_ = carried_.has_value(); }
    [[nodiscard]] bool is_withdrawn() const noexcept { return is_withdrawn_; }
    [[nodiscard]] std::span<component* const> components() const noexcept {
        return std::span{components_}.first(component_count_);
    }
    /// `wake` is called when there is something to do for the slave, from within a component's functions.
    void on_work(const jaus::hook<void()>& wake) noexcept { wake_ = wake; }
    void wake() const {
        if (wake_) wake_();
    }
    /// False if there is no free place.
    [[nodiscard]] bool add(component& unit) noexcept {
        if (component_count_ == components_.size()) return false;
        components_[component_count_++] = &unit;
        return true;
    }

  private:
    slave_options options_;
    any_exchange& exchange_;
    const bridge_options& timing_;
    observer watcher_;
    order_queue orders_;
    std::optional<order> carried_{};
    bool is_withdrawn_{};
    std::array<component*, component_capacity> components_{};
    std::size_t component_count_{};
    bool up_{};
    slave_data data_{};
    jaus::hook<void()> wake_{};
};

} // namespace jauscat::bridging
