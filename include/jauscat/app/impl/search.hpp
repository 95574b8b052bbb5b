// A search for components.
#pragma once
#include <jauscat/app/client.hpp>
#include <jauscat/app/impl/component_state.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

class clients;

/// Asks who is heard, also later, until enough have answered or the timeout is over.
class search : public std::enable_shared_from_this<search> {
  public:
    /// `name` is that of the options, which may refer to it no longer.
    search(component_state& component, clients& by, const find_options& options, std::string name,
           operation_ptr<std::vector<found_component>> done);

    /// The component is there: it, or those of its node, are asked.
    void heard(const jaus::address& who);
    void on_time(time_point now);
    [[nodiscard]] std::optional<time_point> next_event() const { return until_.at(); }
    [[nodiscard]] const operation_ptr<std::vector<found_component>>& done() const noexcept { return done_; }
    /// Its questions are not repeated any more.
    void end_questions();

  private:
    // So that none can stop the node, or the search of the others.
    static constexpr std::size_t most_of_one = 1024; ///< components of one node
    static constexpr std::size_t most_asked = 16;    ///< of them at a time

    struct source { ///< a node
        jaus::address manager{};
        std::vector<std::size_t> waiting{}; ///< places in all_
        std::size_t asked{};                ///< components that have not answered both questions
        std::size_t left_out{};
        bool is_asking{};
    };
    struct candidate {
        found_component it{};
        unsigned questions{2};
        bool has_answered{};
    };

    /// `use` gets the report, if one comes; `over` is called then.
    template <class Query> void ask(const jaus::address& whom, const Query& query, auto use, auto over);
    void add(std::size_t of, const jaus::address& who);
    void ask_more(std::size_t of);
    [[nodiscard]] bool fits(const candidate& one) const;
    void finish();

    component_state& component_;
    clients& by_;
    find_options options_;
    std::string name_;
    deadline until_;
    operation_ptr<std::vector<found_component>> done_;
    std::vector<candidate> all_{};
    std::vector<source> sources_{};
    std::unordered_set<std::uint32_t> known_{};
    std::vector<operation_ptr<bytes>> questions_{};
    std::size_t fitting_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
