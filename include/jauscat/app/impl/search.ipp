// The search for components.
#pragma once
#include <jauscat/app/impl/clients.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <algorithm>
#include <memory>
#include <string>
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
    search(clients& by, const jaus::address& self, const find_options& options, std::string name,
           operation_ptr<std::vector<found_component>> done)
        : by_{by},
          self_{self},
          options_{options},
          name_{std::move(name)},
          until_{net::now(), options.timeout},
          done_{std::move(done)} {}

    void start(const std::vector<jaus::address>& managers) {
        ++open_; // until all have been asked
        for (const auto& manager : managers)
            ask(manager, jaus::query_configuration{jaus::query_field::node_configuration},
                [manager](search& mine, const jaus::report_configuration& report) { mine.found(manager, report); });
        close();
    }

  private:
    template <class Query> void ask(const jaus::address& whom, const Query& query, auto use) {
        std::vector<std::byte> body;
        if (encode_into(body, query) != wire::errc::ok) return;
        ++open_;
        auto answered = [mine = shared_from_this(), use](error_code error, bytes answer) {
            wire::errc why{};
            const owned<jaus::report_of<Query>> report{answer, why};
            if (error == boost::asio::error::operation_aborted) mine->done_->complete(error, {});
            if (!error && why == wire::errc::ok) use(*mine, *report);
            mine->close();
        };
        by_.ask(whom, {jaus::command_code_of<Query>, jaus::command_code_of<jaus::report_of<Query>>}, std::move(body),
                {.timeout = until_.remaining(net::now()), .acknowledged = false},
                std::make_shared<function_operation>(std::move(answered)));
    }
    void found(const jaus::address& manager, const jaus::report_configuration& report) {
        for (const auto& node : report.node)
            for (const auto& one : node.component) {
                const jaus::address who{one.instance_id, one.component_id, node.node_id, manager.subsystem};
                const bool is_wanted = options_.component == 0 || options_.component == who.component;
                if (!is_wanted || who == self_ || place_of(who) != all_.end()) continue;
                all_.push_back({.address = who});
                ask(who, jaus::query_identification{jaus::query_type::component_identification},
                    [who](search& mine, const jaus::report_identification& is) {
                        mine.place_of(who)->identification = is.identification;
                    });
                ask(who, jaus::query_services{}, [who](search& mine, const jaus::report_services& has) {
                    for (const auto& service : has.service) {
                        for (const auto& message : service.input_message)
                            mine.place_of(who)->takes.push_back(message.command_code);
                        for (const auto& message : service.output_message)
                            mine.place_of(who)->sends.push_back(message.command_code);
                    }
                });
            }
    }
    [[nodiscard]] std::vector<found_component>::iterator place_of(const jaus::address& who) {
        return std::ranges::find(all_, who, &found_component::address);
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

    clients& by_;
    jaus::address self_;
    find_options options_;
    std::string name_;
    deadline until_;
    operation_ptr<std::vector<found_component>> done_;
    std::vector<found_component> all_{};
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
        std::make_shared<search>(all, by->self(), options, name, done)->start(managers);
    });
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
