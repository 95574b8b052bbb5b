// A bus behind its handle: one queue of jobs for the master of a ring, which serves the slaves of bridges, too.
#pragma once
#include <jauscat/app/bus_error.hpp>
#include <jauscat/app/bus_options.hpp>
#include <jauscat/app/impl/named_slaves.hpp>
#include <jauscat/app/impl/numbered.hpp>
#include <jauscat/app/impl/ring_thread.hpp>
#include <jauscat/app/object_value.hpp>
#include <jauscat/app/slave.hpp>
#include <jauscat/bridge/ring.hpp>
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/link/ring_runner.hpp>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

class bus_state;

/// The master's error, as an operation has it.
[[nodiscard]] JAUSCAT_DECL error_code error_of(const ethercat::master_error& error) noexcept;
/// An object of a slave, or its entry.
struct object {
    std::uint16_t index{};
    std::optional<std::uint8_t> subindex{};
};
/// The same, and its message names the slave, the object, and for wrong_size the type that was to be read.
[[nodiscard]] JAUSCAT_DECL error_code error_of(const slave_info& slave, const ethercat::master_error& error,
                                               const std::optional<object>& about = {}, std::string_view type = {});
/// Why a slave is lost that was in the state `goal`: `left OP: INIT`.
[[nodiscard]] JAUSCAT_DECL error_code error_of_loss(ethercat::al_state goal, const ethercat::master_error& why);
/// How a log calls the slave.
[[nodiscard]] JAUSCAT_DECL std::string name_of(const slave_info& slave);
/// The times of a ring, without those of bridges.
[[nodiscard]] JAUSCAT_DECL bridging::bridge_options timing_of(const bus_options& options);

/// Something for the master to do in one job or more. It is told when it has come to an end.
class bus_job {
  public:
    bus_job() = default;
    virtual ~bus_job() = default;
    bus_job(const bus_job&) = delete;
    bus_job& operator=(const bus_job&) = delete;

    /// Starts the next job. False: there is none.
    virtual bool begin(bus_state& bus, ethercat::master& master) = 0;
    /// That one has ended.
    virtual void end(bus_state& bus, ethercat::master& master) = 0;
    /// Nobody waits for the outcome.
    [[nodiscard]] virtual bool is_over() const = 0;
    virtual void fail(error_code why) = 0;
    /// Does the work of the next job together with its own, which has not begun. False: that is to be done later.
    [[nodiscard]] virtual bool takes_along(bus_job&) { return false; }

    duration limit{};                  ///< it may take so long
    time_point due{time_point::max()}; ///< since it has begun
};

/// Works with the process data of slaves in operation, before the application does.
class cycle_user {
  public:
    cycle_user() = default;
    virtual ~cycle_user() = default;
    cycle_user(const cycle_user&) = delete;
    cycle_user& operator=(const cycle_user&) = delete;

    virtual void on_cycle(time_point now) = 0;
    /// It comes to rest in the next cycles.
    virtual void begin_rest() = 0;
    [[nodiscard]] virtual bool is_at_rest() const = 0;
    [[nodiscard]] virtual bool uses(std::uint16_t station) const = 0;
    /// Of its slave, with their places.
    [[nodiscard]] virtual std::span<const ethercat::process_object> objects() const = 0;
    virtual void bus_ends() = 0;
};

/// A bridge that serves a slave of the bus, or an operation of the slave.
class bus_user {
  public:
    bus_user() = default;
    virtual ~bus_user() = default;
    bus_user(const bus_user&) = delete;
    bus_user& operator=(const bus_user&) = delete;

    [[nodiscard]] virtual bridging::slave_front& front() noexcept = 0;
    [[nodiscard]] virtual const bridging::slave_front& front() const noexcept = 0;
    /// A message of one of its components.
    virtual void send(std::span<const std::byte> message) = 0;
    /// The bus does not serve the slave any more.
    virtual void bus_ends() noexcept = 0;
    /// Of its components.
    [[nodiscard]] virtual std::uint8_t node() const noexcept = 0;
    /// Brings to rest what it moves.
    virtual void begin_rest(time_point now, jaus::message_sink out);
    /// Rest is to be waited for. A slave that does not answer is not.
    [[nodiscard]] virtual bool awaits_rest() const;
    /// The slave that it waits for is in PRE-OP. Called within the ring's turn.
    virtual void slave_ready() {}

    bool was_up{}; ///< the slave answered when the bus was stopped
};

/// A slave that was found.
struct bus_slave {
    slave_info info{};
    ethercat::al_status al{};
    bool is_identified{};
    bool is_configured{}; ///< its process data, since it was brought up
    error_code why{};     ///< it is lost
    time_point next_look{};

    // Only where the options name slaves.
    named_slave* named{};           ///< nullptr: none of the options
    const named_slave* last_name{}; ///< also of one that is refused now, while it keeps its station address
    ethercat::slave_identity identity{};
    bool is_brought_up{};  ///< and has no start-up objects yet
    bool is_prepared{};    ///< it is that of its name, with its start-up objects since it was brought up
    bool is_absent{};      ///< it is not in the ring; its position is the last one
    time_point next_try{}; ///< to bring it up

    JAUSCAT_DECL void identify(const ethercat::slave_record& record) noexcept;
};

/// A slave in OP whose process data the application exchanges.
class operated_slave final : public bus_user {
  public:
    operated_slave(bus_state& on, const bus_slave& which, const operate_options& options, operation_ptr<> done);
    ~operated_slave() override;

    /// For the application; empty once it is brought to rest.
    [[nodiscard]] std::optional<bridging::slave_data> data() const;
    /// Brings it to rest; then it is to be taken to `goal`, and `done` is to be told.
    void end(ethercat::al_state goal, operation_ptr<> done);
    /// The operation that waits for OP, or for the end.
    [[nodiscard]] const operation_ptr<>& done() const noexcept { return done_; }
    [[nodiscard]] ethercat::al_state goal() const noexcept { return goal_; }
    [[nodiscard]] std::uint16_t station() const noexcept { return front_.station(); }

    enum class progress : std::uint8_t {
        goes_on,
        lost,
        failed, ///< it did not come to OP in time, or nobody waits for it any more
        rests,  ///< the outputs of zeros have arrived, or do not in time
    };
    [[nodiscard]] progress look(time_point now);

    JAUSCAT_DECL void send(std::span<const std::byte>) override {}
    JAUSCAT_DECL void bus_ends() noexcept override;
    JAUSCAT_DECL void begin_rest(time_point now, jaus::message_sink out) override;
    [[nodiscard]] JAUSCAT_DECL bool awaits_rest() const override;
    [[nodiscard]] bridging::slave_front& front() noexcept override { return front_; }
    [[nodiscard]] const bridging::slave_front& front() const noexcept override { return front_; }
    [[nodiscard]] JAUSCAT_DECL std::uint8_t node() const noexcept override { return 0; }

  private:
    /// It has no JAUS messages.
    struct no_exchange final : bridging::any_exchange {
        bridging::exchange_step begin(std::span<const std::byte>, std::span<std::byte>) override { return {}; }
        bridging::exchange_step on_confirmation(std::span<const std::byte>, std::span<std::byte>) override {
            return {};
        }
        [[nodiscard]] hilscher::packet_status status() const override { return {}; }
        [[nodiscard]] translate::errc error() const override { return {}; }
    };
    void slave_up(const bridging::slave_front&, const ethercat::slave_record&, bool ready);
    void slave_lost(const bridging::slave_front&, bridging::loss what, const ethercat::master_error& why);
    void slave_emergency(const bridging::slave_front&, const ethercat::coe_emergency& emergency);
    void clocks_agree(const bridging::slave_front&, ethercat::clock_agreement how, std::uint32_t difference);
    /// More than the bus's `timeout`, to set the clock up.
    static constexpr duration clock_time = std::chrono::seconds{20};
    void rest();

    bus_state& bus_;
    operation_ptr<> done_;
    time_point due_;
    bridging::bridge_options timing_;
    no_exchange exchange_{};
    bridging::order_memory<1, 1> memory_{};
    bridging::slave_front front_;
    ethercat::al_state goal_{ethercat::al_state::op};
    std::optional<time_point> resting_since_{};
    bool is_lost_{};
};

/// One link. What it calls of the application runs later, from the io_context. All functions may be called on the
/// threads of the io_context and of the bus; what they refer to is used under the lock.
class bus_state : public std::enable_shared_from_this<bus_state> {
  public:
    static constexpr std::size_t max_object_size = 65536;
    static constexpr std::size_t max_slaves = 256;
    static constexpr std::size_t max_process_data = 32768;
    static constexpr duration longest_rest = std::chrono::milliseconds{700}; ///< Ctrl-C ends a program within a second
    static constexpr std::uint16_t first_station = 1001;                     ///< JAUS nodes are up to 254

    bus_state(boost::asio::io_context& context, std::string_view where, bus_options options);
    ~bus_state();

    /// Also where a slave is in OP if it `takes_over`, as a bridge does: its slaves may be there since an earlier life
    /// of the program.
    void start(operation_ptr<> done, bool takes_over);
    void read(const slave_choice& which, std::uint16_t index, std::uint8_t subindex, const object_type& type,
              operation_ptr<object_bytes> done);
    void write(const slave_choice& which, std::uint16_t index, std::uint8_t subindex, object_bytes value,
               operation_ptr<> done);
    void list_objects(const slave_choice& which, ethercat::object_list_type list,
                      operation_ptr<std::vector<std::uint16_t>> done);
    void describe(const slave_choice& which, std::uint16_t index, operation_ptr<object_information> done);
    void describe_entry(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                        operation_ptr<entry_information> done);
    void state(const slave_choice& which, operation_ptr<ethercat::al_status> done);
    void error_counters(const slave_choice& which, operation_ptr<ethercat::error_counters> done);
    void change(const slave_choice& which, ethercat::al_state goal, operation_ptr<> done);
    void operate(const slave_choice& which, const operate_options& options, operation_ptr<> done);
    /// Process data of a slave in operation.
    [[nodiscard]] std::optional<bridging::slave_data> data_of(const slave_choice& which);
    [[nodiscard]] bus_statistics statistics() const;
    /// The same, of the slave with this station address. Under the lock.
    [[nodiscard]] std::optional<bridging::slave_data> data_at(std::uint16_t station) const;
    /// Of one that works with the slave in each cycle; empty: there is none. Under the lock.
    [[nodiscard]] std::span<const ethercat::process_object> objects_of(std::uint16_t station) const;
    /// The last cycle has brought the inputs. Under the lock.
    [[nodiscard]] bool is_current(const bridging::slave_data& data) const;
    /// Works in each cycle from now on, until the bus stops.
    void add(const std::shared_ptr<cycle_user>& user);
    /// Where a function of the application counts on it.
    void keep_cycling() noexcept;
    void cancel();
    void stop() noexcept;
    /// The handle has gone: nothing is started any more.
    void close() noexcept;

    // For bridges.

    /// Sets what the bus decides in the times of a bridge, and keeps to them from now on: the cycles have the shortest
    /// period of all. They live until they are released.
    void add_timing(bridging::bridge_options& timing);
    void release_timing(const bridging::bridge_options& timing) noexcept;
    /// A station address that no other slave of a bridge has: that of the node, or else one from 254 down.
    [[nodiscard]] std::uint16_t reserve_station(std::uint16_t node);
    void release_station(std::uint16_t station) noexcept { std::erase(stations_, station); }
    /// Serves the slave of the user's front from now on; empty, or why not.
    [[nodiscard]] std::string join(bus_user& user);
    void leave(const bus_user& user) noexcept;
    /// Waits for at most `longest` until those that work in each cycle are at rest.
    void bring_cycle_users_to_rest(duration longest);
    /// Shuts the components down. Waits for at most `longest` until their slaves have confirmed that they are at rest.
    void bring_to_rest(std::span<bus_user* const> users, duration longest = longest_rest);
    void note_served(bus_user& user, const ethercat::slave_record& record);
    void note_served_lost(bus_user& user, error_code why);
    void note_clocks(ethercat::clock_agreement how, std::uint32_t difference);
    [[nodiscard]] bool is_serving() const noexcept { return !users_.empty(); }
    /// Of the options; nullptr: `which` is none of them.
    [[nodiscard]] named_slave* named(const slave_choice& which) noexcept { return named_.find(which.name.view()); }
    /// Has `which` brought up under this station address. Tells `user` each time when it is in PRE-OP, until `forget`.
    /// False: another bridge waits for it.
    [[nodiscard]] bool await(named_slave& which, bus_user& user, std::uint16_t station);
    void forget(const bus_user& user) noexcept;
    /// Finds the slaves unless they are known.
    void start_once(operation_ptr<> done);

    [[nodiscard]] boost::asio::io_context& context() noexcept { return context_; }
    [[nodiscard]] auto lock() const { return std::unique_lock{mutex_}; }
    /// This is the thread of the bus.
    [[nodiscard]] bool is_own_thread() const noexcept { return thread_ && thread_->is_this(); }
    [[nodiscard]] std::vector<slave_info> infos() const;
    [[nodiscard]] std::vector<slave_status> statuses() const;
    /// Under the lock, with a ring.
    [[nodiscard]] std::optional<bus_clocks> clocks() const;
    /// Nullptr and the error where none, or several, are as required.
    [[nodiscard]] bus_slave* find(const slave_choice& which, error_code& error);
    [[nodiscard]] duration timeout_of(const slave_choice& which);
    void log(std::string_view line) const;
    void show_frame(std::span<const std::byte> frame, bool is_sent) const;

    std::function<void()> on_cycle{};
    std::function<void(const slave_info&, error_code)> on_lost{};
    std::function<void(const slave_info&)> on_found{};
    std::function<void(const slave_info&, const ethercat::al_status&)> on_changed{};
    std::function<void(const slave_info&, const ethercat::coe_emergency&)> on_emergency{};

    // For its jobs.
    [[nodiscard]] const bus_options& options() const noexcept { return options_; }
    [[nodiscard]] ethercat::download_options download_options() const noexcept {
        return {.clear_subindex_0 = options_.clear_subindex_0};
    }
    [[nodiscard]] std::span<std::byte> memory() noexcept { return memory_; }
    [[nodiscard]] bridging::ring& ring() noexcept { return *ring_; }
    [[nodiscard]] std::vector<bus_slave>& slaves() noexcept { return slaves_; }
    void note_lost(bus_slave& slave, error_code why);
    void note_found(bus_slave& slave);
    void note_state(bus_slave& slave, const ethercat::al_status& al);
    /// The frames do not return at all.
    void note_all_lost(error_code why);
    /// Of an operation of this slave.
    void note_outcome(bus_slave& slave, error_code error);
    void note_emergencies(bus_slave& slave, ethercat::master& master);
    void note_emergency(const bus_slave& slave, const ethercat::coe_emergency& emergency);
    [[nodiscard]] bus_slave* at(std::uint16_t station);
    [[nodiscard]] bus_slave* at_position(std::uint16_t position);
    [[nodiscard]] named_slaves& names() noexcept { return named_; }
    [[nodiscard]] bool is_started() const noexcept { return is_started_; }
    void set_started() noexcept { is_started_ = was_started_ = true; }
    /// Slaves in OP may be those that it has left there.
    [[nodiscard]] bool was_started() const noexcept { return was_started_; }

    // For those that find named slaves.
    /// All that are not served.
    void forget_found();
    [[nodiscard]] std::vector<std::pair<std::uint16_t, std::uint16_t>>
    note_positions(const ethercat::master& master, std::span<const std::uint16_t> unknown);
    /// False: it is not.
    [[nodiscard]] bool note_brought_up(const bus_slave& made, error_code why);
    /// Gives the slaves their names, and refuses.
    void match_names();
    [[nodiscard]] bus_slave* next_to_prepare();
    void note_prepared(bus_slave& slave, bool is_start);
    void note_unprepared(bus_slave& slave, error_code why);
    /// Why a named slave cannot be used that must be there.
    [[nodiscard]] error_code first_refusal();

  private:
    /// Messages of the ring, to the node of their source.
    struct ring_output {
        bus_state& of;
        void operator()(std::span<const std::byte> message) const { of.send(message); }
    };

    template <class... Results, class Make, class Take>
    void ask(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take,
             std::string_view type = {});
    void add(std::unique_ptr<bus_job> job, duration limit);
    struct taking_over;
    /// A slave in PRE-OP that is to be operated.
    struct prepared_slave {
        slave_choice which;
        operate_options options;
        operation_ptr<> done;
    };
    void take_over_prepared();
    void take_over(const bus_slave& which, const operate_options& options, const operation_ptr<>& done);
    void run_cycle();
    void queue_change(std::uint16_t station, ethercat::al_state goal, operation_ptr<> done);
    /// Slaves that come, go or move are looked for.
    [[nodiscard]] bool finds_changes() const noexcept;
    /// It is not another one than it was.
    [[nodiscard]] bool is_trusted(const bus_slave& slave) const noexcept;
    /// Its state is read.
    [[nodiscard]] bool is_watched(const bus_slave& slave) const noexcept;
    void sort_slaves();
    [[nodiscard]] bus_slave* slave_of(const named_slave& which) noexcept;
    void refuse(named_slave& which, error_code why, const bus_slave* by);
    /// The slave at the place of `which` may be that one; `before` was.
    [[nodiscard]] static bool may_be(const bus_slave& slave, const named_slave& which, const bus_slave* before);
    void give_name(bus_slave& slave, named_slave& which, bus_slave* before);
    /// Ends operations that are over.
    void look_at_operated(time_point now);
    void end_operations() noexcept;
    /// Drives the ring until `is_done()` holds, at most for `limit`.
    void drive(const std::function<bool()>& is_done, duration limit);
    void open();
    void apply_timings() noexcept;
    void send(std::span<const std::byte> message);
    bool begin_job(ethercat::master& master);
    void end_job(ethercat::master& master);
    std::unique_ptr<bus_job> next_job(time_point now);
    /// Ends what is late; returns when to look again.
    time_point look_at_time();
    void wake();
    void write_line(const std::string& line) const;
    void look_at_link();
    void tell_fault(link_fault what, std::string_view line) const;
    void abort_all(error_code why);
    /// Calls a function of the application from the io_context, unless the bus has ended by then.
    template <class F, class... Arguments> void call_later(F bus_state::* function, Arguments... arguments);

    boost::asio::io_context& context_;
    mutable inheriting_mutex mutex_{};
    std::string where_;
    bus_options options_;
    std::unique_ptr<net::any_link> link_;
    bridging::bridge_options timing_{};
    using ring_type = bridging::ring_for<max_slaves, max_process_data, 16, max_slaves>;
    std::unique_ptr<ring_type> ring_{};
    ring_output output_{*this};
    std::vector<bus_user*> users_{};
    std::vector<prepared_slave> prepared_{};
    std::vector<std::shared_ptr<cycle_user>> cycle_users_{};
    bool has_cycle_thrown_{}; ///< since the last async_operate
    std::vector<std::unique_ptr<operated_slave>> operated_{};
    std::vector<std::uint16_t> stations_{}; ///< of slaves of bridges
    std::vector<const bridging::bridge_options*> timings_{};
    std::optional<net::detail::wake_timer> timer_{};
    std::optional<net::ring_runner<net::any_link>> runner_{};
    std::unique_ptr<ring_thread> thread_{}; ///< in place of timer and runner
    std::optional<boost::asio::executor_work_guard<boost::asio::io_context::executor_type>> work_{}; ///< while it works
    std::vector<std::byte> memory_;
    std::deque<std::unique_ptr<bus_job>> queue_{};
    std::unique_ptr<bus_job> current_{};
    std::vector<bus_slave> slaves_{};
    named_slaves named_;
    std::uint16_t next_station_{first_station};
    bool is_match_due_{};
    time_point next_find_{}; ///< of named slaves that have come, gone or moved
    std::string problem_{};  ///< of the link, as it was logged
    ethercat::clock_agreement clocks_{};
    decltype(bus_statistics::late_cycles) late_cycles_{};
    duration operate_period_{}; ///< of the last async_operate; 0: there was none
    bool looked_last_{};        ///< the last job was a look at a slave
    bool has_seen_master_{}, has_seen_gap_{};
    bool is_started_{}, was_started_{};
    bool is_closed_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
