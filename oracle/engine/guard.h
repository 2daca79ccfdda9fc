// A small process that watches over a group of processes: if this one ends, in whatever way, the group is killed.
#pragma once

#include <sys/types.h>

namespace lgs::oracle {

class Guard {
 public:
  explicit Guard(pid_t group);
  ~Guard();  ///< the guard goes, the group stays
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

 private:
  pid_t guard_ = -1;
  int lifeline_ = -1;  // the guard reads the other end; it is closed when this process ends
};

}  // namespace lgs::oracle
