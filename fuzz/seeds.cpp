// Writes the inputs that fuzzing starts from, a folder per target: the golden messages, the captures and the example
// configuration, each in the form that its target reads.
#include "schema/vectors.hpp"
#include "support/hex.hpp"
#include "support/objects.hpp"
#include "support/paths.hpp"
#include "support/pcap.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/hilscher_info.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/translate/translator.hpp>

#include <filesystem>
#include <iostream>
#include <map>

using namespace jauscat;
using byte_vector = std::vector<std::byte>;

namespace {

class seed_folder {
  public:
    seed_folder(const std::filesystem::path& root, const std::string& target) : folder_{root / target} {
        std::filesystem::create_directories(folder_);
    }
    void add(std::span<const std::byte> seed) {
        std::ofstream file{folder_ / std::to_string(count_++), std::ios::binary};
        for (const std::byte byte : seed) file.put(static_cast<char>(byte));
        if (!file) throw std::runtime_error{"cannot write to " + folder_.string()};
    }

  private:
    std::filesystem::path folder_;
    std::size_t count_{};
};

void append(byte_vector& to, std::span<const std::byte> more) { to.insert(to.end(), more.begin(), more.end()); }

template <class Table> void add_packet(seed_folder& folder, std::span<const std::byte> message) {
    using translator = translate::translator<Table>;
    byte_vector packet(translator::max_packet_size);
    if (const auto translated = translator::to_packet(message, packet)) folder.add(*translated);
}

void write_messages(const std::filesystem::path& root) {
    seed_folder message{root, "message"}, view{root, "view"}, dispatch{root, "dispatch"};
    seed_folder translation{root, "translate"}, stream{root, "stream"}, image{root, "image"};
    byte_vector line(2);
    for (const auto& golden : golden::vectors()) {
        const std::span<const std::byte> whole{golden.bytes};
        byte_vector coded_body{whole[2], whole[3]};
        append(coded_body, whole.subspan(16));
        message.add(coded_body);
        view.add(coded_body);
        dispatch.add(whole);
        translation.add(whole);
        add_packet<translation::seed_table>(translation, whole);
        add_packet<translation::self_contained_table>(translation, whole);
        if (golden.code == jaus::command_code_of<jaus::set_wrench_effort>) {
            byte_vector image_and_body(wire::max_size<translation::wrench_effort_image>);
            append(image_and_body, whole.subspan(16));
            image.add(image_and_body);
        }
        append(line, whole);
        if (line.size() > 200) {
            stream.add(line);
            line.assign(2, std::byte{5});
        }
    }
}

void write_sae_messages(const std::filesystem::path& root) {
    seed_folder messages{root, "sae"};
    std::map<std::string, seed_folder> sets; // by the part of a service's name: urn:jaus:jss:SET:SERVICE
    for (const auto& [part, target] : {std::pair{"core", "sae_core"},
                                       {"mobility", "sae_mobility"},
                                       {"environmentSensing", "sae_environment_sensing"},
                                       {"manipulator", "sae_manipulator"},
                                       {"ugv", "sae_ugv"}})
        sets.emplace(part, seed_folder{root, target});
    constexpr std::string_view before = "urn:jaus:jss:";
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) {
        const auto vector = golden::json::parse(line);
        const auto payload = jauscat::test::from_hex(vector.at("hex").get<std::string>());
        const auto service = vector.at("service").get<std::string>().substr(before.size());
        messages.add(payload);
        sets.at(service.substr(0, service.find(':'))).add(payload);
    }
}

// A frame in the form of fuzz/support/steps.hpp.
byte_vector step_of(const ethercat::frame_view& frame) {
    byte_vector step(1);
    for (const auto datagram : frame) {
        step[0] = static_cast<std::byte>(std::to_integer<unsigned>(step[0]) + 1);
        append(step, datagram.bytes.first(datagram.bytes.size() - 2));
    }
    return step;
}

// Our own master on a link that loses every fifth frame on its way back, so that it asks the slave to repeat its mail.
// (Every third would be the answer to each repeat, for ever.)
byte_vector repeated_session(std::uint8_t options) {
    fuzz::objects objects;
    std::array devices{ethercat::slave{fuzz::description(options), ethercat::object_dictionary{objects}}};
    test::simulated_link link{devices};
    link.record = true;
    ethercat::master_for<16> master;
    const auto done = [&](const auto& job) {
        if (!link.run(master, job)) throw std::runtime_error{"the simulated session fails"};
    };
    done(ethercat::bring_up{0, 2});
    int passed = 0;
    link.on_way_back = [&](byte_vector& frame) {
        if (++passed % 5 == 0) frame.clear();
    };
    const byte_vector data(8);
    byte_vector into(8);
    done(ethercat::download{2, 0x1000, 4, data});
    done(ethercat::upload{2, 0x1000, 2, into});

    byte_vector session{std::byte{options}};
    for (const auto& frame : link.seen) {
        ethercat::frame_view view;
        if (view.parse(frame)) append(session, step_of(view));
    }
    return session;
}

void write_traffic(const std::filesystem::path& root) {
    seed_folder frames{root, "frame"}, mailbox{root, "mailbox"}, slave{root, "slave"}, master{root, "master"};
    for (const auto* capture : {"ethercat_soem_soes.pcap", "ethercat_kickcat.pcap"}) {
        byte_vector session(1);
        std::size_t steps = 0;
        const auto recorded = test::read_pcap(capture);
        for (std::size_t i = 0; i != recorded.size(); ++i) {
            frames.add(recorded[i]);
            ethercat::frame_view view;
            if (!view.parse(recorded[i])) continue;
            for (const auto datagram : view) { // mail, in either direction
                ethercat::mailbox_header header{};
                const auto used = wire::decode_prefix(header, datagram.data);
                if (!used || header.type != ethercat::mailbox_type::coe || header.length > datagram.data.size() - 6)
                    continue;
                byte_vector mail(1);
                append(mail, datagram.data.subspan(*used, header.length));
                mailbox.add(mail);
            }
            if (i % 2 != 0) continue; // the way back
            append(session, step_of(view));
            if (++steps % 60 == 0) slave.add(session);
        }
        slave.add(session);
        byte_vector forged{std::byte{4}};
        append(forged, step_of([&] {
                   ethercat::frame_view view;
                   static_cast<void>(view.parse(recorded[1]));
                   return view;
               }()));
        master.add(forged);
    }
    for (const std::uint8_t options : std::array<std::uint8_t, 3>{0, 2, 4}) slave.add(repeated_session(options));
    master.add(byte_vector(80));                 // all goes well
    master.add(byte_vector(80, std::byte{2}));   // changed
    master.add(byte_vector(2000, std::byte{3})); // answered with anything
    byte_vector lossy;
    for (int i = 0; i != 80; ++i) append(lossy, std::array{std::byte{0}, std::byte{0}, std::byte{1}});
    master.add(lossy);
}

// Transfers in the form of fuzz/segments.cpp, which nothing disturbs, and one that is changed in the middle.
void write_segments(const std::filesystem::path& root) {
    seed_folder segments{root, "segments"};
    for (int options = 0; options != 64; ++options)
        for (const int size : {3, 20, 100})
            segments.add(std::array{std::byte{0}, std::byte{1}, static_cast<std::byte>(options),
                                    static_cast<std::byte>(size), std::byte{0}});
    byte_vector changed{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{100}, std::byte{0}};
    append(changed, byte_vector(6));
    append(changed, std::array{std::byte{6}, std::byte{2}, std::byte{0x80}});
    segments.add(changed);
}

// Packets in the form of fuzz/packets.cpp, all of them in a row and each one after the bus was scanned.
void write_packets(const std::filesystem::path& root) {
    using namespace hilscher;
    seed_folder packets{root, "packets"};
    byte_vector all, scan;
    const auto add = [&](auto packet, std::span<const std::byte> data = {}) {
        packet.head.ul_dest = 0x20;
        const auto size = wire::max_size<decltype(packet)> + data.size();
        packet.head.ul_len = static_cast<std::uint32_t>(size - 40);
        byte_vector step(3 + wire::max_size<decltype(packet)>);
        step[1] = static_cast<std::byte>(size);
        if (!wire::encode(packet, std::span{step}.subspan(3)))
            throw std::runtime_error{"a packet that does not encode"};
        append(step, data);
        step.push_back({}); // nothing is disturbed
        append(all, step);
        if (scan.empty()) scan = step;
        byte_vector after_scan = scan;
        append(after_scan, step);
        packets.add(after_scan);
    };
    constexpr std::array data{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
    add(start_bus_scan_request{.ul_timeout = 1000});
    add(get_bus_scan_info_request{.us_auto_inc_addr = 0xFFFF});
    add(get_slave_handles_request{.ul_param = handle_list::active});
    add(get_od_list_request{.ul_node_id = 1, .ul_list_type = packet_list_type::all});
    add(get_object_description_request{.ul_node_id = 1, .ul_index = 0x1018});
    add(get_entry_description_request{.ul_node_id = 1, .ul_index = 0x1018, .ul_sub_index = 1, .ul_access_bit_mask = 7});
    add(sdo_download_request{.ul_node_id = 1, .ul_index = 0x2000, .ul_sub_index = 1, .ul_data_cnt = 4}, data);
    add(sdo_upload_request{.ul_node_id = 2, .ul_index = 0x2000, .ul_sub_index = 20});
    add(set_state_request{.us_new_ec_state = bus_state::op});
    add(get_state_request{});
    add(read_emergencies_request{.ul_slave_handle = 1, .f_delete_emergency = 1});
    add(set_state_request{.us_new_ec_state = bus_state::init});
    packets.add(all);
}

// Datagrams of the capture and serial frames, in the form of fuzz/sae_transport.cpp.
void write_sae_transport(const std::filesystem::path& root) {
    seed_folder transport{root, "sae_transport"};
    byte_vector all{std::byte{5}};
    for (const auto& frame : test::read_pcap("sae_management.pcap")) {
        constexpr std::size_t udp = 34; // no frame of this capture has options of IP
        const auto size = std::to_integer<std::size_t>(frame.at(udp + 5)) - 8;
        for (const auto value : {size, std::size_t{1}, std::to_integer<std::size_t>(frame.at(29))})
            all.push_back(static_cast<std::byte>(value));
        append(all, std::span{frame}.subspan(udp + 8, size));
    }
    transport.add(all);
    transport.add(test::from_hex("03 10010210100010021a1900101000010a017e002201c8000220010010031c73"));
    transport.add(test::from_hex("03 100102140010027a7e001400010a017e002201c80002201010031010101002001003fc48"));
    transport.add(test::from_hex("03 02 001000010a017e002201c80002200100"));
}

void write_configurations(const std::filesystem::path& root, const std::filesystem::path& example) {
    seed_folder config{root, "config"};
    const auto add = [&config](const std::filesystem::path& path) {
        std::ifstream file{path};
        std::ostringstream text;
        text << file.rdbuf();
        const auto content = text.str();
        config.add(std::as_bytes(std::span{content}));
    };
    add(example);
    for (const auto& file : std::filesystem::directory_iterator{support::source_file("tests/net/config/good")})
        add(file.path());
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "usage: fuzz_seeds FOLDER JausConfig.xml\n";
        return 2;
    }
    try {
        const std::filesystem::path root{arguments[1]};
        write_messages(root);
        write_sae_messages(root);
        write_traffic(root);
        write_segments(root);
        write_packets(root);
        write_sae_transport(root);
        write_configurations(root, arguments[2]);
    } catch (const std::exception& error) {
        std::cerr << "fuzz_seeds: " << error.what() << '\n';
        return 1;
    }
}
