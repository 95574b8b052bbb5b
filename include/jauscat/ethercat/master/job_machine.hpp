// A state machine for each of the master's jobs. The master runs one of them.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/clock_setup.hpp>
#include <jauscat/ethercat/master/datagram_exchange.hpp>
#include <jauscat/ethercat/master/jobs.hpp>
#include <jauscat/ethercat/master/mailbox_exchange.hpp>
#include <jauscat/ethercat/master/mailbox_session.hpp>
#include <jauscat/ethercat/master/parallel_steps.hpp>
#include <jauscat/ethercat/master/ring_scan.hpp>
#include <jauscat/ethercat/master/sdo_information.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/master/slave_bring_up.hpp>
#include <jauscat/ethercat/master/slave_check.hpp>
#include <jauscat/ethercat/master/slave_identification.hpp>
#include <jauscat/ethercat/master/slave_list.hpp>
#include <jauscat/ethercat/master/slave_location.hpp>
#include <jauscat/ethercat/master/slave_setup.hpp>
#include <jauscat/ethercat/master/state_change.hpp>
#include <jauscat/ethercat/master/sync_setup.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

namespace jauscat::ethercat {

/// What the master knows of the ring. The jobs change it.
struct ring_knowledge {
    slave_list slaves;
};

/// The state machine of a job. `begin` takes the job, or says why it has ended at once, as does `is_done` where there
/// is nothing to do; `request` adds the datagrams of the present step and `reply` takes their return; `complete`, after
/// `progress::done`, updates what is known and says how the job has ended; `value` is what it gives. `ring` stays in
/// place from `begin` to `complete`.
template <class Job> class job_machine;

/// A job that a state machine can do.
template <class T>
concept master_job = requires {
    typename T::result_type;
    typename job_machine<T>::steps;
};

namespace detail {

/// The slave with this address, or why it cannot be talked to.
[[nodiscard]] JAUSCAT_FUNCTION master_error choose(slave_list& slaves, std::uint16_t station,
                                                   slave_record*& chosen) noexcept;
/// The same for a job that uses the slave's mailbox.
[[nodiscard]] JAUSCAT_FUNCTION master_error choose_mailbox(slave_list& slaves, std::uint16_t station,
                                                           slave_record*& chosen) noexcept;

/// A job whose frames may all be repeated, and that needs to do nothing when one is lost.
template <class Steps> class plain_machine {
  public:
    using steps = Steps;
    void request(frame_builder& frame) noexcept { steps_.request(frame); }
    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        return steps_.reply(datagrams, now, config);
    }
    [[nodiscard]] static constexpr bool was_refused() noexcept { return false; }
    [[nodiscard]] static constexpr bool is_repeatable() noexcept { return true; }
    static constexpr void lost() noexcept {}
    [[nodiscard]] static master_error cancel(const master_error& why) noexcept { return why; }
    [[nodiscard]] master_error complete(ring_knowledge&) noexcept { return steps_.result().error(); }

  protected:
    Steps steps_{};
};

/// A job that is one transfer or question through a slave's mailbox.
template <class Protocol> class mailbox_machine : public mailbox_session<Protocol> {
  public:
    using steps = mailbox_session<Protocol>;
    [[nodiscard]] master_error complete(ring_knowledge&) noexcept { return this->result().error(); }

  protected:
    [[nodiscard]] master_error begin_protocol(ring_knowledge& ring, std::uint16_t station,
                                              const Protocol& protocol) noexcept {
        slave_record* slave{};
        const auto wrong = choose_mailbox(ring.slaves, station, slave);
        if (wrong == master_error{}) steps::begin(*slave, protocol);
        return wrong;
    }
    // What has come to the front of a buffer.
    template <class Byte> [[nodiscard]] std::span<Byte> received(std::span<Byte> into) const noexcept {
        return into.first(std::min(into.size(), *this->result()));
    }
};

} // namespace detail

template <> class job_machine<scan> : public detail::plain_machine<ring_scan> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION static master_error begin(const scan&, ring_knowledge& ring,
                                                             const master_config&) noexcept;
    [[nodiscard]] std::size_t value() const noexcept { return steps_.slaves(); }
};

namespace detail {

/// Makes the master ready to bring a slave up: what it knows of the slave, or of another one at its address, is away
/// until then.
[[nodiscard]] JAUSCAT_FUNCTION slave_bring_up begin_bring_up(const bring_up& job, slave_list& slaves) noexcept;
/// The record of a slave that is up; it is in the list then.
JAUSCAT_FUNCTION slave_record complete_bring_up(slave_record slave, slave_list& slaves) noexcept;

/// Work on many slaves. The places keep their errors.
template <class Place> class parallel_machine {
  public:
    using steps = parallel_steps<Place>;
    void request(frame_builder& frame) noexcept { steps_.request(frame); }
    [[nodiscard]] bool was_refused() const noexcept { return steps_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return steps_.is_repeatable(); }
    void lost() noexcept { steps_.lost(); }
    [[nodiscard]] master_error cancel(const master_error& why) noexcept {
        steps_.cancel(why);
        return why;
    }
    [[nodiscard]] static master_error complete(ring_knowledge&) noexcept { return {}; }
    /// Whether there is nothing to do.
    [[nodiscard]] bool is_done() const noexcept { return steps_.is_done(); }
    /// Slaves without an error.
    [[nodiscard]] std::size_t value() const noexcept {
        return static_cast<std::size_t>(
            std::ranges::count_if(places_, [](const Place& each) { return each.error == master_error{}; }));
    }

  protected:
    std::span<Place> places_{};
    steps steps_{};
};

} // namespace detail

template <> class job_machine<bring_up> : public detail::plain_machine<slave_bring_up> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const bring_up& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION master_error complete(ring_knowledge& ring) noexcept;
    [[nodiscard]] const slave_record& value() const noexcept { return slave_; }

  private:
    slave_record slave_{};
};

template <> class job_machine<bring_up_all> : public detail::parallel_machine<bring_up_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const bring_up_all& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

  private:
    slave_list* slaves_{};
};

template <> class job_machine<identify> : public detail::plain_machine<slave_identification> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const identify& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] const slave_identity& value() const noexcept { return steps_.value(); }
};

template <> class job_machine<identify_all> : public detail::parallel_machine<identify_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const identify_all& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
};

template <> class job_machine<read_names> : public detail::parallel_machine<name_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const read_names& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
};

template <> class job_machine<locate_slaves> : public detail::plain_machine<slave_location> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const locate_slaves& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point, const master_config&) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION located_slaves value() const noexcept;

  private:
    slave_list* slaves_{};
    std::span<std::uint16_t> into_{};
    std::size_t known_{}, unknown_{};
};

namespace detail {

/// Whether the process data of a slave may be set up.
[[nodiscard]] JAUSCAT_FUNCTION master_error begin_setup(slave_list& slaves, std::uint16_t station,
                                                        std::chrono::nanoseconds watchdog,
                                                        slave_record*& slave) noexcept;

} // namespace detail

template <> class job_machine<configure> {
  public:
    using steps = slave_setup;
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const configure& job, ring_knowledge& ring,
                                                      const master_config& config) noexcept;
    void request(frame_builder& frame) noexcept { steps_.request(frame); }
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
    [[nodiscard]] bool was_refused() const noexcept { return steps_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return steps_.is_repeatable(); }
    void lost() noexcept { steps_.lost(); }
    [[nodiscard]] master_error cancel(const master_error& why) noexcept { return steps_.cancel(why); }
    [[nodiscard]] master_error complete(ring_knowledge&) noexcept { return steps_.result().error(); }
    [[nodiscard]] const process_place& value() const noexcept { return steps_.place(); }

  private:
    std::uint32_t image_end_{};
    steps steps_{};
};

template <> class job_machine<configure_all> : public detail::parallel_machine<configure_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const configure_all& job, ring_knowledge& ring,
                                                      const master_config& config) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

  private:
    std::uint32_t image_end_{};
};

namespace detail {

/// Whether a slave may be taken to a state; it is not drained then.
[[nodiscard]] JAUSCAT_FUNCTION master_error begin_change(slave_list& slaves, std::uint16_t station,
                                                         al_state goal) noexcept;

} // namespace detail

template <> class job_machine<change_state> : public detail::plain_machine<state_change> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const change_state& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
};

template <> class job_machine<change_states> : public detail::parallel_machine<state_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const change_states& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
};

template <> class job_machine<check_positions> : public detail::parallel_machine<position_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const check_positions& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
};

template <> class job_machine<check> : public detail::plain_machine<slave_check> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const check& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION master_error complete(ring_knowledge&) noexcept;
    [[nodiscard]] const al_status& value() const noexcept { return steps_.al(); }

  private:
    slave_record* slave_{};
};

template <> class job_machine<download> : public detail::mailbox_machine<sdo_transfer> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const download& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
};

template <> class job_machine<run_init_commands> {
  public:
    using steps = mailbox_session<sdo_transfer>;
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const run_init_commands& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] bool is_done() const noexcept { return at_ == job_.commands.size(); }
    void request(frame_builder& frame) noexcept { session_.request(frame); }
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
    [[nodiscard]] bool was_refused() const noexcept { return session_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return session_.is_repeatable(); }
    void lost() noexcept { session_.lost(); }
    [[nodiscard]] master_error cancel(const master_error& why) noexcept { return of_command(session_.cancel(why)); }
    [[nodiscard]] master_error complete(ring_knowledge&) noexcept { return of_command(session_.result().error()); }
    [[nodiscard]] std::size_t value() const noexcept { return written_; }

  private:
    // The next one of the transition.
    JAUSCAT_FUNCTION void find() noexcept;
    JAUSCAT_FUNCTION master_error start(slave_list& slaves) noexcept;
    JAUSCAT_FUNCTION void begin_session() noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION master_error of_command(master_error error) const noexcept;

    run_init_commands job_{};
    slave_record* slave_{};
    std::size_t at_{}, written_{};
    steps session_{};
};

template <> class job_machine<upload> : public detail::mailbox_machine<sdo_transfer> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const upload& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] std::span<std::byte> value() const noexcept { return received(into_); }

  private:
    std::span<std::byte> into_{};
};

template <> class job_machine<upload_all> : public detail::parallel_machine<upload_place> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const upload_all& job, ring_knowledge& ring,
                                                      const master_config& config) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
};

template <> class job_machine<list_objects> : public detail::mailbox_machine<sdo_information> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const list_objects& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] object_indices value() const noexcept { return object_indices{received(into_)}; }

  private:
    std::span<const std::byte> into_{};
};

template <> class job_machine<describe_object> : public detail::mailbox_machine<sdo_information> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const describe_object& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION master_result<object_description> value() const noexcept;

  private:
    std::span<const std::byte> into_{};
};

template <> class job_machine<describe_entry> : public detail::mailbox_machine<sdo_information> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const describe_entry& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION master_result<entry_description> value() const noexcept;

  private:
    std::span<const std::byte> into_{};
};

template <> class job_machine<collect_emergencies> {
  public:
    using steps = mailbox_exchange;
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const collect_emergencies& job, ring_knowledge& ring,
                                                      const master_config&) noexcept;
    void request(frame_builder& frame) noexcept { exchange_.request(frame, *slave_, nothing_); }
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
    [[nodiscard]] bool was_refused() const noexcept { return exchange_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return exchange_.is_repeatable(); }
    void lost() noexcept { exchange_.lost(*slave_); }
    [[nodiscard]] JAUSCAT_FUNCTION master_error cancel(const master_error& why) noexcept;
    [[nodiscard]] master_error complete(ring_knowledge&) noexcept { return exchange_.result().error(); }

  private:
    slave_record* slave_{};
    mailbox_exchange exchange_{};
    sdo_transfer nothing_{}; // no request is sent
};

template <> class job_machine<exchange_datagram> : public detail::plain_machine<datagram_exchange> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const exchange_datagram& job, ring_knowledge&,
                                                      const master_config&) noexcept;
    [[nodiscard]] static constexpr bool is_repeatable() noexcept { return false; }
    [[nodiscard]] std::uint16_t value() const noexcept { return steps_.working_counter(); }
};

template <> class job_machine<set_up_clocks> : public detail::plain_machine<clock_setup> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const set_up_clocks& job, ring_knowledge&,
                                                      const master_config&) noexcept;
    [[nodiscard]] const clock_network& value() const noexcept { return steps_.network(); }
};

template <> class job_machine<start_sync> : public detail::plain_machine<sync_setup> {
  public:
    [[nodiscard]] JAUSCAT_FUNCTION master_error begin(const start_sync& job, ring_knowledge&,
                                                      const master_config&) noexcept;
    [[nodiscard]] std::uint64_t value() const noexcept { return steps_.start(); }
};

/// The machine of the job that runs, or of the last one; none before the first one.
using any_job_machine =
    std::variant<std::monostate, job_machine<scan>, job_machine<bring_up>, job_machine<bring_up_all>,
                 job_machine<identify>, job_machine<identify_all>, job_machine<read_names>, job_machine<locate_slaves>,
                 job_machine<configure>, job_machine<configure_all>, job_machine<change_state>,
                 job_machine<change_states>, job_machine<check_positions>, job_machine<check>, job_machine<download>,
                 job_machine<run_init_commands>, job_machine<upload>, job_machine<upload_all>,
                 job_machine<list_objects>, job_machine<describe_object>, job_machine<describe_entry>,
                 job_machine<collect_emergencies>, job_machine<exchange_datagram>, job_machine<set_up_clocks>,
                 job_machine<start_sync>>;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/job_machine.ipp>
#endif
