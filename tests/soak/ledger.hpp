// What was commanded and what came of it: each effort has a number, which travels in its values.
#pragma once

#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace soak {

namespace jaus = jauscat::jaus;

/// Set Wrench Effort with a number in its linear efforts x and y. An effort has 65535 values on the wire, from -100 to
/// 100 percent.
inline constexpr std::uint32_t effort_values = 65535;
inline jaus::set_wrench_effort effort_of(std::uint32_t number) {
    const auto percent = [](std::uint32_t value) { return -100 + 200.0 * value / (effort_values - 1); };
    return {.propulsive_linear_effort_x = percent(number % effort_values),
            .propulsive_linear_effort_y = percent(number / effort_values)};
}
inline std::optional<std::uint32_t> number_of(const jaus::set_wrench_effort& effort) {
    const auto &low = effort.propulsive_linear_effort_x, &high = effort.propulsive_linear_effort_y;
    if (!low || !high) return {};
    const auto value = [](double percent) {
        return static_cast<std::uint32_t>(std::lround((percent + 100) / 200 * (effort_values - 1)));
    };
    return value(*high) * effort_values + value(*low);
}

/// The sender writes what it sent and heard, the robot what it applied, each in memory of its own; it is read when both
/// have ended. All memory is taken and touched at once.
class ledger {
  public:
    explicit ledger(std::size_t most) : efforts_(most), applied_(most) {}

    /// A number for the next effort, if there is room for one. `forbidden`: its sender has no control.
    std::optional<std::uint32_t> next(bool forbidden) {
        if (sent_ == efforts_.size()) return {};
        efforts_[sent_] = {.forbidden = forbidden};
        return static_cast<std::uint32_t>(sent_++);
    }
    /// It was not sent after all.
    void take_back() { --sent_; }
    void delivered(std::uint32_t number, jaus::delivered what) {
        auto& one = efforts_[number];
        ++one.outcomes;
        one.what = what;
    }
    /// By the robot.
    void applied(std::optional<std::uint32_t> number) {
        if (number && *number < applied_.size())
            applied_[*number] = static_cast<std::uint8_t>(std::min(applied_[*number] + 1, 255));
        else
            ++unknown_;
    }

    struct balance {
        std::size_t sent{}, acknowledged{}, refused{}, timed_out{},
            control_lost{},           ///< sent before control went to another: executed or not
            without_outcome{};        ///< each effort is in one of the last
        std::size_t lost{};           ///< acknowledged, and not applied
        std::size_t twice{};          ///< applied more than once
        std::size_t refused_done{};   ///< refused, and applied all the same
        std::size_t forbidden{};      ///< sent without control
        std::size_t forbidden_done{}; ///< and not refused
        std::size_t unknown{};        ///< applied, and never sent
    };
    [[nodiscard]] balance close() const {
        balance all{.sent = sent_, .unknown = unknown_};
        for (std::size_t i = 0; i != applied_.size(); ++i) {
            const auto& [outcomes, what, forbidden] = efforts_[i];
            const auto times = applied_[i];
            if (i >= sent_) {
                if (times != 0) ++all.unknown;
                continue;
            }
            if (times > 1) ++all.twice;
            if (forbidden) ++all.forbidden;
            if (forbidden && (times != 0 || what != jaus::delivered::refused)) ++all.forbidden_done;
            if (outcomes != 1) {
                ++all.without_outcome;
                continue;
            }
            switch (what) {
            case jaus::delivered::acknowledged:
                ++all.acknowledged;
                if (times == 0) ++all.lost;
                break;
            case jaus::delivered::refused:
                ++all.refused;
                if (times != 0) ++all.refused_done;
                break;
            case jaus::delivered::control_lost: ++all.control_lost; break;
            case jaus::delivered::timed_out: ++all.timed_out; break;
            }
        }
        return all;
    }

  private:
    struct entry {
        std::uint8_t outcomes{};
        jaus::delivered what{};
        bool forbidden{};
    };
    std::vector<entry> efforts_;
    std::vector<std::uint8_t> applied_;
    std::size_t sent_{}, unknown_{};
};

} // namespace soak
