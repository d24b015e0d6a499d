package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.scenery.paint.PreparedTile;

/**
 * The pictures that come as resources are those that the painters paint. Whoever changes a painter
 * writes them anew with {@code mvn test -Dtest=WallpaperTest -Dupdate.wallpaper=true}, and builds
 * again.
 */
class WallpaperTest {

  private static final Path FOLDER = Path.of("src/main/resources/tellosimulator/scenery/room");

  @ParameterizedTest
  @EnumSource
  void theResourceIsWhatIsPainted(Wallpaper wallpaper) throws IOException {
    if (Boolean.getBoolean("update.wallpaper")) {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      PreparedTile.write(wallpaper.painted(), bytes);
      Files.createDirectories(FOLDER);
      Files.write(FOLDER.resolve(wallpaper.prepared().file()), bytes.toByteArray());
    }

    assertThat(Wallpaper.class.getResource(wallpaper.prepared().file())).isNotNull();
    assertThat(wallpaper.texture().argbArray()).isEqualTo(wallpaper.painted().argbArray());
  }
}
