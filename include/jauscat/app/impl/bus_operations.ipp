// The operations of a bus on objects and states: one job of the master each.
#pragma once
#include <jauscat/app/impl/bus_state.hpp>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// One job of the master for a slave. `make(slave)` gives that job, `take(value, done)` completes the operation.
template <class Make, class Take, class... Results> class slave_job final : public bus_job {
    using job_type = std::invoke_result_t<Make&, bus_slave&>;

  public:
    slave_job(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take)
        : which_{which}, done_{std::move(done)}, make_{std::move(make)}, take_{std::move(take)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        error_code error;
        auto* const slave = bus.find(which_, error);
        if (slave == nullptr) {
            fail(error);
            return false;
        }
        position_ = slave->info.position;
        return master.start(make_(*slave)).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        const auto outcome = master.result<job_type>();
        const auto error = outcome ? error_code{} : error_of(outcome.error());
        if (auto* const slave = bus.at(position_)) {
            bus.note_outcome(*slave, error);
            bus.note_emergencies(*slave, master);
        }
        if (error) return fail(error);
        if constexpr (std::is_void_v<typename job_type::result_type::value_type>)
            take_(*done_);
        else
            take_(*outcome, *done_);
    }
    [[nodiscard]] bool is_over() const override { return done_->is_done(); }
    void fail(error_code why) override { done_->complete(why, Results{}...); }

  private:
    slave_choice which_;
    operation_ptr<Results...> done_;
    Make make_;
    Take take_;
    std::uint16_t position_{};
};

template <class... Results, class Make, class Take>
void bus_state::ask(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take) {
    using job = slave_job<Make, Take, Results...>;
    add(std::make_unique<job>(which, std::move(done), std::move(make), std::move(take)), options_.timeout);
}

JAUSCAT_DECL void bus_state::read(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                  std::optional<std::size_t> size, operation_ptr<object_bytes> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) {
            return ethercat::upload{slave.info.station, index, subindex, memory_, {.size = size}};
        },
        [](auto value, auto& to) { to.complete({}, {value.begin(), value.end()}); });
}
JAUSCAT_DECL void bus_state::write(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                   object_bytes value, operation_ptr<> done) {
    ask(
        which, std::move(done),
        [=, this, data = std::move(value)](const bus_slave& slave) {
            return ethercat::download{slave.info.station, index, subindex, data, download_options()};
        },
        [](auto& to) { to.complete({}); });
}
JAUSCAT_DECL void bus_state::list_objects(const slave_choice& which, ethercat::object_list_type list,
                                          operation_ptr<std::vector<std::uint16_t>> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) { return ethercat::list_objects{slave.info.station, list, memory_}; },
        [](const auto& indices, auto& to) {
            std::vector<std::uint16_t> all;
            for (const auto index : indices) all.push_back(index);
            to.complete({}, std::move(all));
        });
}
JAUSCAT_DECL void bus_state::describe(const slave_choice& which, std::uint16_t index,
                                      operation_ptr<object_information> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) { return ethercat::describe_object{slave.info.station, index, memory_}; },
        [](const auto& found, auto& to) { to.complete({}, {found.object, std::string{found.name}}); });
}
JAUSCAT_DECL void bus_state::describe_entry(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                            operation_ptr<entry_information> done) {
    constexpr std::uint8_t all_values = 0x7F;
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) {
            return ethercat::describe_entry{slave.info.station, index, subindex, all_values, memory_};
        },
        [](const auto& found, auto& to) {
            const auto copy = [](auto value) { return object_bytes(value.begin(), value.end()); };
            to.complete({}, {found.entry, std::string{found.name}, found.unit, copy(found.default_value),
                             copy(found.minimum), copy(found.maximum)});
        });
}
JAUSCAT_DECL void bus_state::state(const slave_choice& which, operation_ptr<ethercat::al_status> done) {
    ask(
        which, std::move(done), [](const bus_slave& slave) { return ethercat::check{slave.info.station}; },
        [](const ethercat::al_status& al, auto& to) { to.complete({}, al); });
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
