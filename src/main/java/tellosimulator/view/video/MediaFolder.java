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
 * The folders for a user's pictures and videos. They are inside the operating system's own folders
 * for pictures and videos if these exist, and otherwise inside the user's home folder. Immutable.
 *
 * @param home the user's home folder
 */
public record MediaFolder(Path home) {

  /** The name of the folder inside each of the system's folders. */
  private static final String FOLDER = "Tello Simulator";

  /**
   * Candidate names of the pictures folder. Documented: these are the names in the file system on
   * all systems, unless a Linux desktop translates them.
   */
  private static final List<String> FOR_PICTURES = List.of("Pictures", "Bilder");

  /**
   * Candidate names of the videos folder. Documented: Windows and Linux call it Videos, macOS
   * Movies.
   */
  private static final List<String> FOR_FILMS = List.of("Videos", "Movies");

  private static final DateTimeFormatter MOMENT =
      DateTimeFormatter.ofPattern("uuuu-MM-dd_HH-mm-ss", Locale.ROOT);

  /** Returns the folders of the current user. */
  public static MediaFolder ofUser() {
    return new MediaFolder(Path.of(System.getProperty("user.home")));
  }

  /**
   * Returns an unused file for a picture; creates the folder if necessary. Other callers may get
   * the same name until the file exists.
   *
   * @param drone the number of the drone
   * @throws IOException if the folder cannot be created
   */
  Path picture(int drone, LocalDateTime moment) throws IOException {
    return free(folder(FOR_PICTURES), drone, moment, ".png");
  }

  /**
   * Returns an unused file for a video; creates the folder if necessary.
   *
   * @param drone the number of the drone
   * @throws IOException if the folder cannot be created
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
