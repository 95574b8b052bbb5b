// A program of the simulated system: it runs, freezes, dies and starts again, on a clock of its own.
#pragma once

#include "simulation/network.hpp"

namespace simulation {

/// The clock of a process is that of the world plus what it has leapt. A frozen process keeps what arrives, as its
/// socket does, as far as there is room.
class process : public actor, public port_user {
  public:
    process(world& w, network& n, std::string name)
        : world_{w}, network_{n}, number_{w.add(std::move(name))}, port_{n.add(*this)}, random_{w.stream(number_)} {}

    void start() {
        begin();
        for (const fault kind : {fault::process_killed, fault::process_frozen, fault::clock_leap}) try_later(kind);
    }

    [[nodiscard]] std::uint8_t number() const noexcept override { return number_; }
    [[nodiscard]] std::uint8_t port() const noexcept { return port_; }
    /// Which life of the process this is; it counts on while it is dead.
    [[nodiscard]] std::uint32_t life() const noexcept { return life_; }
    [[nodiscard]] bool running() const noexcept { return condition_ == condition::running; }
    /// Since when it does nothing, if that is so.
    [[nodiscard]] std::optional<time> silent_since() const noexcept {
        return running() ? std::nullopt : std::optional{changed_at_};
    }
    /// How long a datagram has waited in its socket.
    [[nodiscard]] time waited(const datagram& one) const noexcept { return world_.now() - one.arrived; }
    /// Its clock.
    [[nodiscard]] time local() const noexcept { return world_.now() + leapt_; }
    /// The same, for the library.
    [[nodiscard]] jauscat::time_point now() const noexcept { return jauscat::time_point{local()}; }
    /// Grows only while it runs.
    [[nodiscard]] time run_time() const noexcept { return (running() ? world_.now() : changed_at_) - idle_; }
    /// When it last ceased to run.
    [[nodiscard]] time last_silence() const noexcept { return last_silence_; }
    /// When its clock or the process itself has last made a jump.
    [[nodiscard]] time jumped_at() const noexcept { return jumped_at_; }

    /// When its clock has last leapt.
    [[nodiscard]] time leapt_at() const noexcept { return leapt_at_; }

    void on_event(std::uint8_t what, std::uint32_t argument) final {
        switch (what) {
        case wake_up:
            if (running() && world_.now() == wake_at_) drive();
            return;
        case restart:
            if (condition_ == condition::dead) begin();
            return;
        case thaw: return go_on(argument);
        case trial: return suffer(static_cast<fault>(argument));
        case script:
            if (argument != life_) return; // of an earlier life
            if (running()) {
                act();
                if (running()) rearm();
            }
            if (condition_ != condition::dead)
                world_.in(random_.between(std::chrono::milliseconds{10}, act_interval()), *this, script, life_);
            return;
        default: return own_event(what, argument);
        }
    }
    bool arrives(datagram& one) final {
        if (condition_ == condition::dead) return false;
        if (condition_ == condition::frozen) {
            if (inbox_.size() >= 64) return false;
            inbox_.push_back(&one);
            return true;
        }
        receive(one);
        if (running()) rearm();
        return false;
    }
    /// After each step.
    virtual void check() {}
    /// For the world: as kill -9 does.
    void die(time pause) {
        if (condition_ == condition::dead) return;
        for (const datagram* waiting : inbox_) network_.give_back(*waiting);
        inbox_.clear();
        kill();
        change(condition::dead);
        world_.tell({.what = deed::dies, .who = number_});
        world_.in(pause, *this, restart);
    }

  protected:
    enum : std::uint8_t { wake_up, restart, thaw, trial, script, first_own_event };

    /// The program begins; it knows nothing of an earlier life.
    virtual void boot() = 0;
    virtual void kill() = 0;
    virtual void receive(const datagram& one) = 0;
    /// Time has passed.
    virtual void run() = 0;
    /// When `run` is wanted, on the process's clock.
    [[nodiscard]] virtual std::optional<time> next() = 0;
    /// What its user or its own mind does, now and then.
    virtual void act() {}
    [[nodiscard]] virtual time act_interval() const { return std::chrono::milliseconds{200}; }
    virtual void own_event(std::uint8_t, std::uint32_t) {}

    void rearm() {
        const auto wanted = next();
        if (!wanted) return;
        const bool is_over = *wanted - leapt_ <= world_.now();
        if (is_over && spun_at_ + std::chrono::milliseconds{1} > world_.now())
            ++spins_;
        else
            spins_ = 0;
        if (is_over) spun_at_ = world_.now();
        if (spins_ > 2000)
            world_.breaks({.point = contract::s6,
                           .who = number_,
                           .expected = "a time to wait for after the work is done",
                           .found = "it wants to be driven again at once, without end"});
        // A turn of the loop takes time; one that has nothing to do must not stop the world.
        const time at = std::max(*wanted - leapt_, world_.now() + (spins_ > 4 ? turn : time{}));
        if (at >= wake_at_ && wake_at_ > world_.now()) return;
        wake_at_ = at;
        world_.at(at, *this, wake_up);
    }

    world& world_;
    network& network_;

  private:
    enum class condition : std::uint8_t { dead, running, frozen };
    static constexpr time turn = std::chrono::microseconds{50};

    void change(condition to) {
        if (condition_ != condition::running) idle_ += world_.now() - changed_at_;
        condition_ = to;
        changed_at_ = world_.now();
        if (to != condition::running) last_silence_ = world_.now();
    }
    void begin() {
        change(condition::running);
        ++life_;
        wake_at_ = time::max();
        jumped_at_ = world_.now();
        leapt_ += random_.between(time{}, std::chrono::seconds{100});
        world_.tell({.what = deed::starts, .who = number_, .number = static_cast<std::uint16_t>(life_)});
        boot();
        rearm();
        world_.in(random_.between(std::chrono::milliseconds{10}, std::chrono::milliseconds{300}), *this, script, life_);
    }
    void drive() {
        wake_at_ = time::max();
        run();
        rearm();
    }
    void try_later(fault kind) {
        world_.in(world_.faults.pause(kind, std::chrono::seconds{3}), *this, trial, static_cast<std::uint32_t>(kind));
    }
    void suffer(fault kind) {
        try_later(kind);
        if (!running() || !world_.faults.strikes(kind, 150'000)) return;
        auto& random = world_.faults.random(kind);
        const time some = random.between(std::chrono::milliseconds{5}, std::chrono::seconds{4});
        const auto ms = static_cast<std::uint32_t>(some / std::chrono::milliseconds{1});
        switch (kind) {
        case fault::process_killed: return die(some);
        case fault::process_frozen:
            change(condition::frozen);
            world_.tell({.what = deed::freezes, .who = number_, .value = ms});
            world_.in(some, *this, thaw, life_);
            return;
        default:
            leapt_ += some;
            jumped_at_ = leapt_at_ = world_.now();
            wake_at_ = time::max();
            world_.tell({.what = deed::clock_leaps, .who = number_, .value = ms});
            rearm();
        }
    }
    void go_on(std::uint32_t life) {
        if (life != life_ || condition_ != condition::frozen) return;
        change(condition::running);
        jumped_at_ = world_.now();
        wake_at_ = time::max();
        world_.tell({.what = deed::goes_on, .who = number_});
        // Whether the timers or the socket come first depends on the program.
        const bool timers_first = random_.below(2) == 0;
        if (timers_first) run();
        for (const datagram* waiting : inbox_) {
            if (running()) receive(*waiting);
            network_.give_back(*waiting);
        }
        inbox_.clear();
        if (running()) rearm();
    }

    std::uint8_t number_;
    std::uint8_t port_;
    condition condition_{condition::dead};
    std::uint32_t life_{};
    time changed_at_{}, idle_{}, leapt_{}, jumped_at_{}, leapt_at_{}, last_silence_{};
    time wake_at_{time::max()};
    unsigned spins_{}; ///< in a row
    time spun_at_{};
    std::vector<const datagram*> inbox_{};

  protected:
    generator random_; ///< of this process
};

} // namespace simulation
