// An emulated CiA 402 drive whose PDOs its master maps.
//     docs_mapped_drive
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <array>
#include <iostream>

using namespace jauscat;

int main() {
    // [drive]
    cia402::emulated_drive<> drive{};
    ethercat::standard_objects dictionary{cia402::drive_description<>, drive};
    ethercat::assignable_pdos pdos{cia402::drive_description<>, dictionary};
    ethercat::slave slave{cia402::drive_description<>, pdos};
    const auto work = [&](time_point now) { drive.work(slave, pdos, now); };
    // [drive end]
    work({});
    std::array<std::byte, 1> count{};
    static_cast<void>(pdos.read(0x1600, 0, count));
    std::cout << "at first 1600h has " << std::to_integer<int>(count[0]) << " objects\n";
}
