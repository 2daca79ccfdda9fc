# Linux on a mainframe, run by qemu: the most significant byte of a number comes first there. Debian:
# g++-s390x-linux-gnu, qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR s390x)
set(CMAKE_C_COMPILER s390x-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER s390x-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)  # so that it needs no libraries of that system to run
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-s390x)
