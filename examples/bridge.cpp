// A bridge: a JAUS component whose actuator is the first slave of an EtherCAT bus.
//     bridge --this b
#include <jauscat/app.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

int main(int argc, char** argv) {
    jauscat::node node{argc, argv};
    jauscat::bus bus{node.context(), "udp:127.0.0.1"}; // or a network interface, "eth0"
    jauscat::bridge bridge{node, bus, jauscat::translation::seed_table{}};
    bridge.serve({.component = 33}, bus.slave({.position = 0}));
    return node.run();
}
