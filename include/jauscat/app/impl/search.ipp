// The search for components.
#pragma once
#include <jauscat/app/impl/clients.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// Calls a function at once.
class function_operation final : public operation<bytes> {
  public:
    explicit function_operation(std::function<void(error_code, bytes)> f) : f_{std::move(f)} {}

  private:
    void deliver(error_code error, bytes body) override { f_(error, body); }
    std::function<void(error_code, bytes)> f_;
};

/// Ends when each question is answered or its timeout is over.
class search : public std::enable_shared_from_this<search> {
  public:
    /// `name` is that of the options, which may refer to it no longer.
    search(const node_state& node, clients& by, const jaus::address& self, const find_options& options,
           std::string name, operation_ptr<std::vector<found_component>> done)
        : node_{node},
          by_{by},
          self_{self},
          options_{options},
          name_{std::move(name)},
          until_{net::now(), options.timeout},
          done_{std::move(done)} {}

    void start(const std::vector<jaus::address>& managers) {
        for (const auto& manager : managers) sources_.push_back({manager});
        ++open_; // until all have been asked
        for (std::size_t i = 0; i != sources_.size(); ++i)
            ask(sources_[i].manager, jaus::query_configuration{jaus::query_field::node_configuration},
                [i](search& mine, const jaus::report_configuration& report) { mine.found(mine.sources_[i], report); });
        close();
    }

  private:
    // So that none can stop the node, or the search of the others.
    static constexpr std::size_t most_of_one = 1024; ///< components of one node manager
    static constexpr std::size_t most_asked = 16;    ///< of them at a time

    struct source {
        jaus::address manager{};
        std::vector<std::size_t> waiting{}; ///< places in all_
        std::size_t questions{};            ///< that are not answered
        bool is_asking{};
    };

    /// `use` gets the report, if one comes; `over` is called then.
    template <class Query>
    void ask(const jaus::address& whom, const Query& query, auto use, std::function<void(search&)> over = {}) {
        std::vector<std::byte> body;
        if (encode_into(body, query) != wire::errc::ok) return;
        ++open_;
        auto answered = [mine = shared_from_this(), use, over = std::move(over)](error_code error, bytes answer) {
            wire::errc why{};
            const owned<jaus::report_of<Query>> report{answer, why};
            if (error == boost::asio::error::operation_aborted) mine->done_->complete(error, {});
            if (!error && why == wire::errc::ok) use(*mine, *report);
            if (over && !mine->done_->is_done()) over(*mine);
            mine->close();
        };
        by_.ask(whom, {jaus::command_code_of<Query>, jaus::command_code_of<jaus::report_of<Query>>}, std::move(body),
                {.timeout = until_.remaining(net::now()), .acknowledged = false},
                std::make_shared<function_operation>(std::move(answered)));
    }
    void found(source& by, const jaus::report_configuration& report) {
        std::size_t left_out = 0;
        for (const auto& node : report.node)
            for (const auto& one : node.component) {
                const jaus::address who{one.instance_id, one.component_id, node.node_id, by.manager.subsystem};
                const bool is_wanted = options_.component == 0 || options_.component == who.component;
                if (!is_wanted || who == self_ || known_.contains(std::bit_cast<std::uint32_t>(who))) continue;
                if (by.waiting.size() == most_of_one) {
                    ++left_out;
                    continue;
                }
                known_.insert(std::bit_cast<std::uint32_t>(who));
                by.waiting.push_back(all_.size());
                all_.push_back({.address = who});
            }
        if (left_out != 0)
            node_.log(net::to_jausip(by.manager) + " reports " + std::to_string(left_out + most_of_one) +
                      " components: only " + std::to_string(most_of_one) + " are asked");
        std::ranges::reverse(by.waiting);
        ask_more(by);
    }
    void ask_more(source& by) {
        if (std::exchange(by.is_asking, true)) return; // a question that cannot be sent ends at once
        while (!by.waiting.empty() && by.questions <= 2 * (most_asked - 1)) {
            const auto place = by.waiting.back();
            by.waiting.pop_back();
            by.questions += 2;
            const auto answered = [&by](search& mine) {
                --by.questions;
                mine.ask_more(by);
            };
            ask(
                all_[place].address, jaus::query_identification{jaus::query_type::component_identification},
                [place](search& mine, const jaus::report_identification& is) {
                    mine.all_[place].identification = is.identification;
                },
                answered);
            ask(
                all_[place].address, jaus::query_services{},
                [place](search& mine, const jaus::report_services& has) {
                    for (const auto& service : has.service) {
                        for (const auto& message : service.input_message)
                            mine.all_[place].takes.push_back(message.command_code);
                        for (const auto& message : service.output_message)
                            mine.all_[place].sends.push_back(message.command_code);
                    }
                },
                answered);
        }
        by.is_asking = false;
    }
    void close() {
        if (--open_ != 0) return;
        std::erase_if(all_, [&](const found_component& one) {
            const auto has = [&](const auto& codes) {
                return std::ranges::find(codes, options_.command_code) != codes.end();
            };
            if (one.takes.empty()) return true; // it has not answered
            if (one.identification.find(name_) == std::string::npos) return true;
            return options_.command_code != 0 && !has(one.takes) && !has(one.sends);
        });
        done_->complete({}, std::move(all_));
    }

    const node_state& node_;
    clients& by_;
    jaus::address self_;
    find_options options_;
    std::string name_;
    deadline until_;
    operation_ptr<std::vector<found_component>> done_;
    std::vector<found_component> all_{};
    std::vector<source> sources_{};
    std::unordered_set<std::uint32_t> known_{};
    std::size_t open_{};
};

JAUSCAT_DECL void begin_find(const std::shared_ptr<component_state>& by, const find_options& options,
                             const operation_ptr<std::vector<found_component>>& done) {
    enqueue(by, done, [by, options, name = std::string{options.name}, done](clients& all) {
        std::vector<jaus::address> managers{by->node().net().manager()};
        if (const auto* const present = by->node().net().present(); present != nullptr)
            present->for_each([&](const jaus::address& who) {
                if (jaus::is_node_manager(who) && who != managers.front()) managers.push_back(who);
            });
        std::make_shared<search>(by->node(), all, by->self(), options, name, done)->start(managers);
    });
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
