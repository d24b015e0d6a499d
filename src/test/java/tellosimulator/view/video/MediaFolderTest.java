package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MediaFolderTest {

  private static final LocalDateTime MOMENT = LocalDateTime.of(2025, 3, 4, 15, 6, 7);

  @TempDir private Path home;

  @Test
  void picturesAndFilmsGoWhereTheSystemHasThem() throws IOException {
    Files.createDirectory(home.resolve("Pictures"));
    Files.createDirectory(home.resolve("Movies"));
    MediaFolder folder = new MediaFolder(home);

    assertThat(folder.picture(2, MOMENT))
        .isEqualTo(home.resolve("Pictures/Tello Simulator/tello-2_2025-03-04_15-06-07.png"));
    assertThat(folder.film(1, MOMENT))
        .isEqualTo(home.resolve("Movies/Tello Simulator/tello-1_2025-03-04_15-06-07.mp4"));
  }

  @Test
  void whereTheSystemHasNoSuchFolderTheyGoBelowHome() throws IOException {
    Path file = new MediaFolder(home).film(1, MOMENT);

    assertThat(file.getParent()).isEqualTo(home.resolve("Tello Simulator")).isDirectory();
  }

  @Test
  void twoOfTheSameSecondHaveDifferentNames() throws IOException {
    MediaFolder folder = new MediaFolder(home);
    Path first = Files.createFile(folder.picture(1, MOMENT));
    Path second = Files.createFile(folder.picture(1, MOMENT));
    Path third = folder.picture(1, MOMENT);

    assertThat(second).isNotEqualTo(first).hasFileName("tello-1_2025-03-04_15-06-07_2.png");
    assertThat(third).hasFileName("tello-1_2025-03-04_15-06-07_3.png");
  }

  @Test
  void aFileInTheWayOfTheFolderIsNamed() throws IOException {
    Path inTheWay = Files.createFile(home.resolve("Tello Simulator"));

    assertThatThrownBy(() -> new MediaFolder(home).picture(1, MOMENT))
        .isInstanceOf(FileAlreadyExistsException.class)
        .hasMessage(inTheWay.toString());
  }
}
