// The emulated EtherCAT slave.
#include <jauscat/ethercat/slave/impl/assignable_pdos.ipp>
#include <jauscat/ethercat/slave/impl/coe_server.ipp>
#include <jauscat/ethercat/slave/impl/esc.ipp>
#include <jauscat/ethercat/slave/impl/esc_memory.ipp>
#include <jauscat/ethercat/slave/impl/fmmu_overlap.ipp>
#include <jauscat/ethercat/slave/impl/loopback_link.ipp>
#include <jauscat/ethercat/slave/impl/mapped_objects.ipp>
#include <jauscat/ethercat/slave/impl/sii_image.ipp>
#include <jauscat/ethercat/slave/impl/slave.ipp>
#include <jauscat/ethercat/slave/impl/slave_clock.ipp>
#include <jauscat/ethercat/slave/impl/slave_mailbox.ipp>
#include <jauscat/ethercat/slave/impl/slave_objects.ipp>
#include <jauscat/ethercat/slave/impl/slave_process_data.ipp>
#include <jauscat/ethercat/slave/impl/slave_tree.ipp>
#include <jauscat/ethercat/slave/impl/standard_objects.ipp>
