/* Worlds saved, loaded, and refused: every byte made another one. */
#include "check.h"

typedef struct File {
  uint8_t bytes[4096];
  size_t size;
} File;

static void append(void* user, const uint8_t* bytes, size_t count) {
  File* file = (File*)user;
  CHECK(count <= sizeof file->bytes - file->size);
  memcpy(file->bytes + file->size, bytes, count);
  file->size += count;
}

static lgs_status loaded(const File* file, size_t size, lgs_error* error) {
  lgs_world* world = NULL;
  const lgs_status status = lgs_load(file->bytes, size, NULL, &world, error);
  CHECK((status == LGS_OK) == (world != NULL));
  lgs_free(world);
  return status;
}

static void saving(void) {
  static File file;
  static uint8_t bytes[sizeof file.bytes];
  lgs_world *world = newWorld(), *back = NULL;
  const lgs_shape_id square = squareOf(world);
  lgs_error error;
  lgs_world_options options;
  size_t count = 0;
  int calls = 0;
  placed(world, cellAt(0, 0), square, 1);
  placed(world, cellAt(1, 0), square, 2);
  REFUSED(LGS_UNCOMMITTED, lgs_save(world, append, &file, &error));
  REFUSED(LGS_UNCOMMITTED, lgs_save_to_buffer(world, bytes, sizeof bytes, &count, &error));
  CHECK(file.size == 0 && count == 0 && lgs_commit(world, NULL) == LGS_OK);
  CHECK(lgs_save(world, append, &file, NULL) == LGS_OK && file.size > 0);
  CHECK(lgs_save_to_buffer(world, bytes, sizeof bytes, &count, NULL) == LGS_OK && count == file.size);
  CHECK(memcmp(bytes, file.bytes, count) == 0);
  memset(bytes, 0x55, sizeof bytes);
  REFUSED(LGS_SHORT_BUFFER, lgs_save_to_buffer(world, bytes, 9, &count, &error));
  CHECK(count == file.size && memcmp(bytes, file.bytes, 9) == 0 && bytes[9] == 0x55);

  CHECK(lgs_load(file.bytes, file.size, NULL, &back, NULL) == LGS_OK && isUnchanged(world, back));
  CHECK(samePolygon(placed(world, cellAt(9, 9), square, 1), placed(back, cellAt(9, 9), square, 1)));
  lgs_free(back);
  back = NULL;

  REFUSED(LGS_SAVE_CUT, loaded(&file, 9, &error));
  CHECK(error.offset == 9);
  REFUSED(LGS_SAVE_DAMAGED, loaded(&file, file.size - 1, &error));
  file.bytes[file.size / 2] ^= 1;
  REFUSED(LGS_SAVE_DAMAGED, loaded(&file, file.size, &error));
  file.bytes[file.size / 2] ^= 1;
  file.bytes[0] ^= 1;
  REFUSED(LGS_SAVE_NO_SNAPSHOT, loaded(&file, file.size, &error));
  file.bytes[0] ^= 1;
  lgs_default_world_options(&options, sizeof options);
  options.preserve = keepsOthers;
  options.user = &calls;
  REFUSED(LGS_SAVE_RELATION, lgs_load(file.bytes, file.size, &options, &back, &error));
  options.size = 0;
  REFUSED(LGS_BAD_ARGUMENT, lgs_load(file.bytes, file.size, &options, &back, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_load(NULL, 1, NULL, &back, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_load(file.bytes, file.size, NULL, NULL, &error));
  REFUSED(LGS_SAVE_CUT, lgs_load(NULL, 0, NULL, &back, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_save(NULL, append, &file, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_save(world, NULL, &file, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_save_to_buffer(NULL, bytes, 1, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_save_to_buffer(world, NULL, 1, NULL, &error));
  lgs_free(world);
}

/* A world of several pieces goes into a buffer of any size, and not beyond. */
static void savingInPieces(void) {
  const lgs_local_point upper[3] = {{0, 0}, {U, U}, {0, U}};
  lgs_world* world = newWorld();
  uint32_t random = 1;
  uint8_t *whole, *part;
  size_t count = 0, size = 0, written;
  int32_t k;
  for (k = 0; k < 10000; ++k) {
    random = random * UINT32_C(1664525) + UINT32_C(1013904223);
    CHECK(lgs_add_points(world, cellAt(k % 100, k / 100), random >> 31 ? kRamp : upper, 3, 1, NULL, NULL) == LGS_OK);
  }
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  CHECK(lgs_save_to_buffer(world, NULL, 0, &size, NULL) == LGS_SHORT_BUFFER && size > 3 * 4096);
  whole = (uint8_t*)malloc(size);
  part = (uint8_t*)malloc(size);
  CHECK(whole && part);
  CHECK(lgs_save_to_buffer(world, whole, size, &count, NULL) == LGS_OK && count == size);
  for (written = 4000; written < size; written += 4096) {
    memset(part, 0x55, size);
    CHECK(lgs_save_to_buffer(world, part, written, &count, NULL) == LGS_SHORT_BUFFER && count == size);
    CHECK(memcmp(part, whole, written) == 0);
    for (count = written; count < size; ++count) CHECK(part[count] == 0x55);
  }
  free(part);
  free(whole);
  lgs_free(world);
}

/* Puts the checksum of docs/internals/snapshot.md at the end. */
static void seal(File* file) {
  uint32_t sum = UINT32_MAX;
  size_t k;
  int bit;
  for (k = 0; k < file->size - 4; ++k) {
    sum ^= file->bytes[k];
    for (bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1) != 0 ? UINT32_C(0xedb88320) : 0);
  }
  for (k = 0; k < 4; ++k) file->bytes[file->size - 4 + k] = (uint8_t)(~sum >> 8 * k);
}

/* Every byte of a saved world is made another one, with a checksum that fits. */
static void madeUp(void) {
  static File file;
  lgs_world* world = newWorld();
  lgs_error error;
  int seen[LGS_SAVE_CAPACITY + 1] = {0};
  size_t k;
  int change;
  CHECK(lgs_add_points(world, cellAt(0, 0), kRamp, 3, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_add(world, cellAt(1, 0), squareOf(world), 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_save(world, append, &file, NULL) == LGS_OK);
  for (k = 0; k < file.size - 4; ++k) {
    for (change = 1; change < 256; change *= 2) {
      lgs_status status;
      file.bytes[k] ^= (uint8_t)change;
      seal(&file);
      status = loaded(&file, file.size, &error);
      CHECK(status == LGS_OK || (status >= LGS_SAVE_NO_SNAPSHOT && status <= LGS_SAVE_CAPACITY));
      if (status == LGS_SAVE_UNKNOWN_VERSION) CHECK(error.index == file.bytes[k] && error.index2 == 2);
      ++seen[status];
      file.bytes[k] ^= (uint8_t)change;
    }
  }
  CHECK(seen[LGS_OK] > 0 && seen[LGS_SAVE_NO_SNAPSHOT] > 0 && seen[LGS_SAVE_UNKNOWN_VERSION] > 0);
  CHECK(seen[LGS_SAVE_TOO_LONG] > 0 && seen[LGS_SAVE_CUT] > 0 && seen[LGS_SAVE_RELATION] > 0);
  CHECK(seen[LGS_SAVE_BAD_NUMBER] > 0 && seen[LGS_SAVE_BAD_POLYGON] > 0 && seen[LGS_SAVE_BAD_SEGMENTS] > 0);
  seal(&file);
  CHECK(loaded(&file, file.size, &error) == LGS_OK);
  lgs_free(world);
}

int main(void) {
  saving();
  savingInPieces();
  madeUp();
  return 0;
}
