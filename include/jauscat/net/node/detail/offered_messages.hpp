// Messages that a component and its application accept and send, for Report Services.
#pragma once

#include <jauscat/jaus/component/core_messages.hpp>

#include <algorithm>
#include <vector>

namespace jauscat::net::detail {

/// Each code once, without those of the core service, up to the limit of Report Services.
struct offered_messages {
    std::vector<jaus::supported_message> input{}, output{};

    /// Calls `list_messages(takes, sends)` of those in `all` that have it.
    explicit offered_messages(const auto&... all) { (add(all), ...); }
    void add(const auto& one) {
        const auto takes = [this](const jaus::supported_message& m) { add(input, jaus::core_messages::input, m); };
        const auto sends = [this](const jaus::supported_message& m) { add(output, jaus::core_messages::output, m); };
        if constexpr (requires { one.list_messages(takes, sends); }) one.list_messages(takes, sends);
    }

  private:
    static void add(std::vector<jaus::supported_message>& list, const auto& core, const jaus::supported_message& m) {
        constexpr std::size_t most = 255;
        const auto code = &jaus::supported_message::command_code;
        if (std::ranges::find(core, m.command_code, code) != core.end()) return;
        const auto known = std::ranges::find(list, m.command_code, code);
        if (known != list.end())
            known->supported_presence_vector |= m.supported_presence_vector;
        else if (list.size() != most)
            list.push_back(m);
    }
};

} // namespace jauscat::net::detail
