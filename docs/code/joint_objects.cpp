// Joint messages by SDO: downloads of a command, and a report of uploads. Code of drives.md.
//     docs_joint_objects
// [includes]
#include <jauscat/bridge/joints/object_jobs.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/schema/translation/joint_tables.hpp>
// [includes end]
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <iostream>

using namespace jauscat;

int main() {
    cia402::emulated_drive<> drive{};
    ethercat::standard_objects dictionary{cia402::drive_description<>, drive};
    ethercat::slave slave{cia402::drive_description<>, dictionary};
    const std::array<translation::joint_scale, 1> scales{{{.full_effort = 500}}};
    const std::array body{std::byte{1}, std::byte{0xFF}, std::byte{0xFF}}; // one joint, 100 %

    ethercat::loopback_link link{std::span{&slave, 1}};
    ethercat::master_for<1> master;
    if (!net::run(link, master, ethercat::bring_up{.position = 0, .station = 1})) return 1;
    // [sdo]
    const std::array<bridging::axis_address, 1> where{{{.station = 1, .axis = 0}}};
    bridging::object_downloads<translation::set_joint_efforts_table<1>, 1> downloads;
    if (!downloads.make(body, scales, where)) return 1;
    for (const auto& job : downloads.jobs())
        if (!net::run(link, master, job)) return 1;

    bridging::object_uploads<translation::report_joint_efforts_table<1>, 1> uploads{where};
    for (std::size_t i = 0; i != uploads.jobs().size(); ++i)
        if (const auto read = net::run(link, master, uploads.jobs()[i])) uploads.on_read(i, *read);
    std::array<std::byte, 16> report_body{};
    const auto made = uploads.report(scales, report_body); // refused while an object has not been read
    // [sdo end]
    std::cout << "joint 1: Target torque = " << drive.axes[0].values.target_torque << '\n';
    std::cout << "Report Joint Efforts: " << (made ? made->size() : 0) << " bytes\n";
    return 0;
}
