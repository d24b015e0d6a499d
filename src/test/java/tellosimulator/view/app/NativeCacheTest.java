package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NativeCacheTest {

  @TempDir private Path home;
  @TempDir private Path temporary;

  @Test
  void theUsualFolderIsTakenIfItHasRoomAndNothingStaysInIt() throws IOException {
    Path usual = home.resolve("a").resolve("b");

    assertThat(new NativeCache(usual, temporary, 100_000).folder()).contains(usual);
    assertThat(filesIn(usual)).isZero();
  }

  @Test
  void whereAFileIsInTheWayThereIsAnotherFolder() throws IOException {
    Path usual = Files.createFile(home.resolve("file")).resolve("cache");

    Path folder = new NativeCache(usual, temporary, 100_000).folder().orElseThrow();

    assertThat(folder).hasParent(temporary).isEmptyDirectory();
  }

  @Test
  void withoutRoomAnywhereThereIsNoneAndNothingStays() throws IOException {
    assertThat(new NativeCache(home, temporary, Long.MAX_VALUE).folder()).isEmpty();
    assertThat(filesIn(temporary)).isZero();
  }

  @Test
  void librariesThatAreThereNeedNoRoom() throws IOException {
    Path library = home.resolve("21.0.12+1").resolve("amd64");
    Files.createDirectories(library);
    Files.createFile(library.resolve(System.mapLibraryName("glass")));

    assertThat(new NativeCache(home, temporary, Long.MAX_VALUE).folder()).contains(home);
  }

  private static long filesIn(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.count();
    }
  }
}
