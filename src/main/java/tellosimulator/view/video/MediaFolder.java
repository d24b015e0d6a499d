package tellosimulator.view.video;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;

/**
 * Folders for the pictures and films of a person: below the folder that the system has for them, if
 * there is one. Immutable; for any thread.
 *
 * @param home the person's folder
 */
public record MediaFolder(Path home) {

  /** Its name in each of the system's folders. */
  private static final String FOLDER = "Tello Simulator";

  /** Documented: the names in the file system on all systems, unless Linux translates them. */
  private static final List<String> FOR_PICTURES = List.of("Pictures", "Bilder");

  /** Documented: Windows and Linux call it Videos, macOS Movies. */
  private static final List<String> FOR_FILMS = List.of("Videos", "Movies");

  private static final DateTimeFormatter MOMENT =
      DateTimeFormatter.ofPattern("uuuu-MM-dd_HH-mm-ss", Locale.ROOT);

  /** That of the person who runs the program. */
  public static MediaFolder ofUser() {
    return new MediaFolder(Path.of(System.getProperty("user.home")));
  }

  /**
   * A file for a picture, which does not exist yet; its folder does. Others may be given the same
   * until it does.
   *
   * @param drone that took it
   * @throws IOException if there can be no folder
   */
  Path picture(int drone, LocalDateTime moment) throws IOException {
    return free(folder(FOR_PICTURES), drone, moment, ".png");
  }

  /**
   * A file for a film, which does not exist yet; its folder does.
   *
   * @param drone that took it
   * @throws IOException if there can be no folder
   */
  Path film(int drone, LocalDateTime moment) throws IOException {
    return free(folder(FOR_FILMS), drone, moment, ".mp4");
  }

  private Path folder(List<String> names) throws IOException {
    Path parent =
        names.stream().map(home::resolve).filter(Files::isDirectory).findFirst().orElse(home);
    return Files.createDirectories(parent.resolve(FOLDER));
  }

  private static Path free(Path folder, int drone, LocalDateTime moment, String ending) {
    String name = "tello-" + drone + "_" + MOMENT.format(moment);
    Path file = folder.resolve(name + ending);
    for (int number = 2; Files.exists(file, LinkOption.NOFOLLOW_LINKS); number++) {
      file = folder.resolve(name + "_" + number + ending);
    }
    return file;
  }
}
