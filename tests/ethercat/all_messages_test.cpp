// Every message of the standard across the EtherCAT wire: master, frames, emulated slaves, and the messages they make
// of their objects.
#include "schema/messages.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/bridge/packet_exchange.hpp>
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

#include <array>
#include <set>
#include <vector>

using namespace jauscat;
using bridging::exchange_progress;
using test::to_hex;

namespace {

using bytes = std::vector<std::byte>;
using seed_table = translation::seed_table;
using self_contained_table = translation::self_contained_table;

/// Accepts every object of a message, and returns the object of the message `upwards`.
template <class Table> class message_slave {
  public:
    explicit message_slave(const bridging::slave_identity& self) : self_{self} {}

    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        received.resize(delivery::translator::max_message_size);
        const auto restored = delivery::message_of({self_.station, index, subindex, data}, self_, received);
        received.resize(restored->size());
        return restored ? ethercat::abort_code::none : ethercat::abort_code::parameter_incompatible;
    }
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        bytes packet(delivery::translator::max_packet_size);
        const auto translated = delivery::translator::to_packet(upwards, packet);
        const auto object = delivery::object_of(*translated);
        if (!translated || object.index != index || object.subindex != subindex)
            return {.error = ethercat::abort_code::no_data};
        if (object.data.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        std::ranges::copy(object.data, out.begin());
        return {.size = object.data.size()};
    }

    bytes received{}; ///< the last message that was written
    bytes upwards{};  ///< what is read
    std::array<std::byte, Table::max_data> transfer_memory{};

  private:
    using delivery = bridging::delivery<Table>;
    bridging::slave_identity self_;
};

/// Three slaves in a ring, a master, and messages that go to them.
template <class Table> class robot {
  public:
    using packet_exchange = bridging::packet_exchange<Table>;
    static constexpr std::array<std::uint16_t, 3> stations{1, 100, 254};
    static constexpr std::uint8_t subsystem = 7, instance = 9; ///< of each of them

    message_slave<Table> applications[3]{
        message_slave<Table>{{.subsystem = subsystem, .station = stations[0], .instance = instance}},
        message_slave<Table>{{.subsystem = subsystem, .station = stations[1], .instance = instance}},
        message_slave<Table>{{.subsystem = subsystem, .station = stations[2], .instance = instance}}};

    robot() {
        for (std::uint16_t position = 0; position != stations.size(); ++position) {
            REQUIRE(net::run(link_, master_, ethercat::bring_up{position, stations[position]}));
        }
    }

    /// Has a request packet executed and returns its confirmation.
    bytes execute(std::span<const std::byte> request) {
        bytes confirmation(ethercat::packet_job::confirmation_size);
        ethercat::packet_job job{request, confirmation};
        REQUIRE(job.start(master_));
        static_cast<void>(net::run(link_, master_));
        CHECK_FALSE(job.next(master_));
        confirmation.resize(job.finish(master_));
        return confirmation;
    }

  private:
    // Mailboxes of several sizes: what does not fit goes in segments.
    static ethercat::slave make(message_slave<Table>& application, std::uint16_t mailbox) {
        return {{.vendor = 1, .product = 2, .mailbox_out_size = mailbox, .mailbox_in_size = mailbox},
                application,
                {.transfer_memory = application.transfer_memory}};
    }
    std::array<ethercat::slave, 3> devices_{make(applications[0], 1486), make(applications[1], 128),
                                            make(applications[2], 32)};
    ethercat::loopback_link link_{devices_};
    ethercat::master_for<16> master_{};
};

/// A message to one of the stations, with any header that can be delivered.
jaus::header random_header(support::generator& g, std::uint16_t code, std::size_t body) {
    const auto& stations = robot<seed_table>::stations;
    auto head = support::random_message<jaus::header>(g);
    head.command_code = code;
    head.destination.node = static_cast<std::uint8_t>(stations[support::below(g, stations.size())]);
    head.data_size = static_cast<std::uint16_t>(body);
    head.data_flag = jaus::data_flag::only;
    return head;
}
bytes message_of(const jaus::header& head, const bytes& body) {
    bytes message(jaus::header_size + body.size());
    REQUIRE(wire::encode(head, message));
    std::ranges::copy(body, message.begin() + jaus::header_size);
    return message;
}

/// What the slave has received must be `expected(header)` with the same body.
template <class Table> void every_message_arrives(auto expected) {
    robot<Table> r;
    support::generator g{254};
    std::set<std::uint16_t> codes;
    for (const auto& type : messages::all()) {
        INFO(type.name());
        for (int round = 0; round != 10; ++round) {
            const auto body = type.random(g, {}).bytes;
            if (body.size() > robot<Table>::packet_exchange::translator::max_body) continue;
            const auto head = random_header(g, type.code, body.size());
            const auto message = message_of(head, body);
            INFO(to_hex(message));
            typename robot<Table>::packet_exchange exchange{{}};
            bytes buffer(exchange.buffer_size);
            const auto step = exchange.begin(message, buffer);
            if (step.what != exchange_progress::request) FAIL(describe(exchange.error()));
            const auto confirmation = r.execute(std::span{buffer}.first(step.size));
            REQUIRE(exchange.on_confirmation(confirmation, buffer).what != exchange_progress::failed);
            const auto at = std::ranges::find(r.stations, head.destination.node) - r.stations.begin();
            REQUIRE(to_hex(r.applications[at].received) == to_hex(message_of(expected(head), body)));
            codes.insert(type.code);
        }
    }
    CHECK(codes.size() == 158);
}

} // namespace

TEST_CASE("under the self-contained table every message reaches its slave byte for byte") {
    every_message_arrives<self_contained_table>([](const jaus::header& sent) { return sent; });
}

TEST_CASE("under the seed table every message reaches its slave with that slave's subsystem and instance, otherwise "
          "unchanged") {
    every_message_arrives<seed_table>([](jaus::header sent) {
        sent.destination.subsystem = robot<seed_table>::subsystem;
        sent.destination.instance = robot<seed_table>::instance;
        return sent;
    });
}

TEMPLATE_TEST_CASE("parts of a large data set and broadcasts that name no slave are refused before they are sent", "",
                   seed_table, self_contained_table) {
    support::generator g{11};
    bridging::packet_exchange<TestType> exchange{{}};
    bytes buffer(exchange.buffer_size);
    const auto error = [&](const jaus::header& head) {
        const auto step = exchange.begin(message_of(head, {}), buffer);
        REQUIRE(step.what == exchange_progress::failed);
        return exchange.error();
    };
    for (const auto& type : messages::all()) {
        INFO(type.name());
        auto head = random_header(g, type.code, 0);
        for (const auto flag :
             {jaus::data_flag::first, jaus::data_flag::middle, jaus::data_flag::repeated, jaus::data_flag::last}) {
            head.data_flag = flag;
            REQUIRE(error(head) == translate::errc::fragment_to_slave);
        }
        head.data_flag = jaus::data_flag::only;
        for (const std::uint8_t node : {std::uint8_t{0}, std::uint8_t{255}}) {
            head.destination.node = node;
            REQUIRE(error(head) == translate::errc::broadcast_names_no_slave);
        }
    }
}

TEMPLATE_TEST_CASE("the report of every query returns with the asker's address and the query's number", "", seed_table,
                   self_contained_table) {
    robot<TestType> r;
    support::generator g{0x2000};
    const auto all = messages::all();
    std::set<std::uint16_t> codes;
    for (const auto& query : all) {
        const auto report_code = jaus::report_code_of(query.code);
        if (report_code == 0) continue;
        const auto report = std::ranges::find(all, report_code, &messages::message::code);
        REQUIRE(report != all.end());
        INFO(query.name());
        for (int round = 0; round != 5; ++round) {
            const auto asked = query.random(g, {}).bytes, told = report->random(g, {}).bytes;
            if (told.size() > robot<TestType>::packet_exchange::translator::max_body) continue;
            auto question = random_header(g, query.code, asked.size());
            question.destination.component = 38;
            question.destination.instance = 3;
            question.destination.subsystem = 4;
            // The report is stored in the slave as a message to itself.
            auto answer = random_header(g, report_code, told.size());
            answer.destination.component = 38;
            answer.destination.node = question.destination.node;
            const auto at = std::ranges::find(r.stations, question.destination.node) - r.stations.begin();
            r.applications[at].upwards = message_of(answer, told);

            typename robot<TestType>::packet_exchange exchange{{}};
            bytes buffer(exchange.buffer_size);
            auto step = exchange.begin(message_of(question, asked), buffer);
            int requests = 0;
            while (step.what == exchange_progress::request) {
                ++requests;
                const auto confirmation = r.execute(std::span{buffer}.first(step.size));
                step = exchange.on_confirmation(confirmation, buffer);
            }
            REQUIRE(step.what == exchange_progress::done);
            REQUIRE(requests == 2);
            answer.destination = question.source;
            answer.source = question.destination;
            answer.sequence_number = question.sequence_number;
            REQUIRE(to_hex(std::span{buffer}.first(step.size)) == to_hex(message_of(answer, told)));
            codes.insert(query.code);
        }
    }
    CHECK(codes.size() == 48);
}
