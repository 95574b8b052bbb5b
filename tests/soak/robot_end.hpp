// The robot of the soak.
#pragma once

#include "soak/end.hpp"
#include "soak/ledger.hpp"
#include <jauscat/jaus/component/component.hpp>

namespace soak {

/// Applies efforts, and remembers who has controlled it.
class robot_end : public end {
  public:
    robot_end(const net::jaus_config& config, ledger& book) : end{config, robot_id, operator_id}, book_{book} {
        core_.change(jaus::state_event::initialized);
        node_.add(core_, application_);
    }
    ~robot_end() override { stop(); }

    void send_large() {
        call([this] { large.send(node_); });
    }
    /// Nobody has no address.
    [[nodiscard]] std::vector<std::optional<jaus::address>> controllers() {
        std::vector<std::optional<jaus::address>> found;
        call([&] { found = controllers_; });
        return found;
    }
    [[nodiscard]] std::uint64_t count(jaus::component_outcome what) {
        std::uint64_t found{};
        call([&] { found = core_.count(what); });
        return found;
    }

    std::atomic<std::uint64_t> applied{};

  private:
    void stopped() override {}

    void on_controller(const std::optional<jaus::controller>& now, jaus::control_change) {
        controllers_.push_back(now ? std::optional{now->address} : std::nullopt);
    }
    struct handler {
        robot_end& mine;
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte> body) const {
            if (head.command_code != jaus::command_code_of<jaus::set_wrench_effort>)
                return take_large(mine.large, head, body);
            return jaus::decode_for<jaus::set_wrench_effort>(body, [&](const jaus::set_wrench_effort& effort) {
                mine.book_.applied(number_of(effort));
                ++mine.applied;
            });
        }
    } application_{*this};

    static constexpr std::array<std::uint16_t, 1> harmless{image_code};

    ledger& book_;
    std::vector<std::optional<jaus::address>> controllers_{};
    // 1000 a second for two seconds are at most half of what can be remembered.
    jaus::component_memory<16, 256, 5000> memory_{};
    jaus::component<> core_{robot_id,
                            memory_,
                            {.on_controller = jaus::bound<&robot_end::on_controller>(*this)},
                            {.control = {.harmless = harmless}}};
};

} // namespace soak
