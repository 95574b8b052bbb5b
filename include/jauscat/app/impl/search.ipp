// The functions of search.
#pragma once
#include <jauscat/app/impl/clients.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/app/impl/search.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

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

JAUSCAT_DECL search::search(component_state& component, clients& by, const find_options& options, std::string name,
                            operation_ptr<std::vector<found_component>> done)
    : component_{component},
      by_{by},
      options_{options},
      name_{std::move(name)},
      until_{net::now(), options.timeout},
      done_{std::move(done)} {}

template <class Query> inline void search::ask(const jaus::address& whom, const Query& query, auto use, auto over) {
    std::vector<std::byte> body;
    if (!encode_into(body, query)) return;
    auto answered = [weak = weak_from_this(), use, over](error_code error, bytes answer) {
        const auto mine = weak.lock();
        if (mine == nullptr || mine->done_->is_done()) return;
        wire::errc why{};
        const owned<jaus::report_of<Query>> report{answer, why};
        if (!error && why == wire::errc::ok) use(*mine, *report);
        over(*mine);
    };
    const auto question = std::make_shared<function_operation>(std::move(answered));
    std::erase_if(questions_, [](const auto& one) { return one->is_done(); });
    questions_.push_back(question);
    by_.ask(whom, {jaus::command_code_of<Query>, jaus::command_code_of<jaus::report_of<Query>>}, std::move(body),
            {.timeout = std::min(until_.remaining(net::now()), by_.patience()), .acknowledged = false}, question);
}

JAUSCAT_DECL void search::heard(const jaus::address& who) {
    const jaus::address manager{1, 1, who.node, who.subsystem};
    const auto found = std::ranges::find(sources_, manager, &source::manager);
    const auto of = static_cast<std::size_t>(found - sources_.begin());
    if (found == sources_.end()) {
        sources_.push_back({.manager = manager});
        const auto configured = [of](search& mine, const jaus::report_configuration& report) {
            for (const auto& node : report.node)
                for (const auto& one : node.component)
                    mine.add(of,
                             {one.instance_id, one.component_id, node.node_id, mine.sources_[of].manager.subsystem});
            if (const auto left_out = std::exchange(mine.sources_[of].left_out, std::size_t{}); left_out != 0)
                mine.component_.node().log(net::to_jausip(mine.sources_[of].manager) + " reports " +
                                           std::to_string(left_out + most_of_one) + " components: only " +
                                           std::to_string(most_of_one) + " are asked");
            mine.ask_more(of);
        };
        // The node may have none: others of it are heard then.
        if (who == manager || component_.is_routable(manager))
            ask(manager, jaus::query_configuration{jaus::query_field::node_configuration}, configured, [](search&) {});
    }
    if (who == manager || done_->is_done()) return;
    add(of, who);
    ask_more(of);
}

JAUSCAT_DECL void search::add(std::size_t of, const jaus::address& who) {
    const bool is_wanted = options_.component == 0 || options_.component == who.component;
    if (!is_wanted || who == component_.self() || known_.contains(std::bit_cast<std::uint32_t>(who))) return;
    auto& by = sources_[of];
    if (by.waiting.size() == most_of_one) return void(++by.left_out);
    known_.insert(std::bit_cast<std::uint32_t>(who));
    by.waiting.insert(by.waiting.begin(), all_.size());
    all_.push_back({.it = {.address = who}});
}

JAUSCAT_DECL void search::ask_more(std::size_t of) {
    if (std::exchange(sources_[of].is_asking, true)) return; // a question that cannot be sent ends at once
    while (!done_->is_done() && !sources_[of].waiting.empty() && sources_[of].asked < most_asked) {
        const auto place = sources_[of].waiting.back();
        sources_[of].waiting.pop_back();
        ++sources_[of].asked;
        const auto whom = all_[place].it.address;
        const auto over = [of, place](search& mine) {
            auto& one = mine.all_[place];
            if (--one.questions != 0) return;
            --mine.sources_[of].asked;
            if (mine.fits(one) && ++mine.fitting_ == mine.options_.count) return mine.finish();
            mine.ask_more(of);
        };
        ask(
            whom, jaus::query_identification{jaus::query_type::component_identification},
            [place](search& mine, const jaus::report_identification& is) {
                mine.all_[place].has_answered = true;
                mine.all_[place].it.identification = is.identification;
            },
            over);
        ask(
            whom, jaus::query_services{},
            [place](search& mine, const jaus::report_services& has) {
                auto& one = mine.all_[place];
                one.has_answered = true;
                for (const auto& service : has.service) {
                    for (const auto& message : service.input_message) one.it.takes.push_back(message.command_code);
                    for (const auto& message : service.output_message) one.it.sends.push_back(message.command_code);
                }
            },
            over);
    }
    sources_[of].is_asking = false;
}

JAUSCAT_DECL bool search::fits(const candidate& one) const {
    const auto has = [&](const auto& codes) { return std::ranges::find(codes, options_.command_code) != codes.end(); };
    return one.has_answered && one.it.identification.find(name_) != std::string::npos &&
           (options_.command_code == 0 || has(one.it.takes) || has(one.it.sends));
}

JAUSCAT_DECL void search::on_time(time_point now) {
    if (until_.is_reached(now)) finish();
}

JAUSCAT_DECL void search::finish() {
    std::vector<found_component> found;
    for (auto& one : all_)
        if (fits(one)) found.push_back(std::move(one.it));
    done_->complete({}, std::move(found));
    end_questions();
}

JAUSCAT_DECL void search::end_questions() {
    for (const auto& one : std::exchange(questions_, {})) one->complete(boost::asio::error::operation_aborted, {});
}

JAUSCAT_DECL void begin_find(const std::shared_ptr<component_state>& by, const find_options& options,
                             const operation_ptr<std::vector<found_component>>& done) {
    enqueue(by, done, [by, options, name = std::string{options.name}, done](clients& all) {
        std::vector<jaus::address> heard{by->node().net().manager()};
        if (const auto* const present = by->node().net().present(); present != nullptr)
            present->for_each([&](const jaus::address& who) { heard.push_back(who); });
        all.begin(std::make_shared<search>(*by, all, options, name, done), heard);
    });
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
