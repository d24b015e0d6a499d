package tellosimulator.view.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SettingsTest {

  private static final long SECOND = 1_000_000_000;

  @TempDir Path directory;

  private final DoubleProperty scale = new SimpleDoubleProperty(1);
  private final BooleanProperty trail = new SimpleBooleanProperty(true);

  private enum Theme {
    SYSTEM,
    LIGHT,
    DARK
  }

  private final ObjectProperty<Theme> theme = new SimpleObjectProperty<>(Theme.SYSTEM);

  @Test
  void whatWasSetIsThereTheNextTime() throws IOException {
    Settings first = load();
    scale.set(1.5);
    trail.set(false);
    theme.set(Theme.DARK);
    first.save();

    scale.set(1);
    trail.set(true);
    theme.set(Theme.SYSTEM);
    load();

    assertThat(scale.get()).isEqualTo(1.5);
    assertThat(trail.get()).isFalse();
    assertThat(theme.get()).isEqualTo(Theme.DARK);
    assertThat(files()).containsExactly("settings.properties");
  }

  @Test
  void onlyWhatDiffersFromItsDefaultIsWritten() throws IOException {
    Settings settings = load();
    scale.set(2);
    theme.set(Theme.LIGHT);
    theme.set(Theme.SYSTEM);
    settings.save();

    assertThat(lines()).containsExactly("scale=2.0");
  }

  @Test
  void nothingIsWrittenUnlessSomethingChanged() throws IOException {
    Settings settings = load();

    settings.beat(0);
    settings.beat(100 * SECOND);
    settings.save();

    assertThat(files()).isEmpty();
  }

  @Test
  void isWrittenOnceItIsCalm() throws IOException {
    Settings settings = load();
    settings.beat(0);
    scale.set(1.1);
    settings.beat(5 * SECOND);
    settings.beat(5 * SECOND + SECOND / 2);
    scale.set(1.2);
    settings.beat(6 * SECOND);
    settings.beat(6 * SECOND + SECOND / 2);
    assertThat(files()).isEmpty();

    settings.beat(7 * SECOND);

    assertThat(Files.readString(file())).contains("scale=1.2");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "scale=3.1",
        "scale=0.1",
        "scale=NaN",
        "scale=Infinity",
        "scale=-1e999",
        "scale=large",
        "scale=",
        "scale",
        "trail=TRUE",
        "trail=1",
        "theme=DARK",
        "theme=purple\nscale=1e5",
        "theme=\\u00",
        "\\uZZZZ=1",
        "scale=\\u0000",
        "=====\n\n\\\\\\",
      })
  void whatIsNotAllowedFallsBack(String content) throws IOException {
    Files.writeString(file(), content);

    Settings settings = load();

    assertThat(scale.get()).isEqualTo(1);
    assertThat(trail.get()).isTrue();
    assertThat(theme.get()).isEqualTo(Theme.SYSTEM);
    scale.set(2);
    settings.save();
    assertThat(Files.readString(file())).contains("scale=2.0").doesNotContain("purple");
  }

  @Test
  void oneWrongValueSpoilsNoOther() throws IOException {
    Files.writeString(file(), "scale=7000\ntrail=false\nunheard-of=1\n");

    load();

    assertThat(scale.get()).isEqualTo(1);
    assertThat(trail.get()).isFalse();
  }

  @Test
  void bytesAtRandomDisturbNobody() throws IOException {
    for (int seed = 0; seed < 50; seed++) {
      byte[] garbage = new byte[4000];
      new Random(seed).nextBytes(garbage);
      Files.write(file(), garbage);

      load();

      assertThat(scale.get()).isEqualTo(1);
    }
  }

  @Test
  void aHugeFileIsNotRead() throws IOException {
    Files.write(file(), "trail=false\n".getBytes(StandardCharsets.UTF_8));
    try (RandomAccessFile huge = new RandomAccessFile(file().toFile(), "rw")) {
      huge.setLength(100_000_000);
    }

    Settings settings = load();

    assertThat(trail.get()).isTrue();
    scale.set(2);
    settings.save();
    assertThat(Files.size(file())).isLessThan(1000);
  }

  @Test
  void aMissingDirectoryIsMade() throws IOException {
    Path deep = directory.resolve("a").resolve("b").resolve("settings.properties");
    Settings settings = bound(Settings.load(deep));
    scale.set(2);
    settings.save();

    assertThat(Files.readString(deep)).contains("scale=2.0");
  }

  @Test
  void aDirectoryInTheFilesPlaceDisturbsNobody() throws IOException {
    Files.createDirectories(file().resolve("inner"));

    Settings settings = load();
    scale.set(2);
    settings.save();

    assertThat(file().resolve("inner")).isDirectory();
    assertThat(files()).containsExactly("settings.properties");
  }

  @Test
  void aFileInTheDirectorysPlaceDisturbsNobody() throws IOException {
    Files.writeString(directory.resolve("a"), "");
    Settings settings = bound(Settings.load(directory.resolve("a").resolve("settings.properties")));

    scale.set(2);
    settings.save();

    assertThat(directory.resolve("a")).isEmptyFile();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void aDirectoryThatCannotBeWrittenDisturbsNobody() {
    Settings settings = bound(Settings.load(Path.of("/proc/tello-simulator/settings.properties")));

    scale.set(2);
    settings.save();
    scale.set(3);
    settings.save();

    assertThat(scale.get()).isEqualTo(3);
  }

  @Test
  void whoBindsAKeyNextGetsItsValue() {
    Settings settings = load();
    trail.set(!trail.get());
    boolean left = trail.get();

    settings.unbind("trail");
    BooleanProperty next = new SimpleBooleanProperty(!left);
    settings.bind("trail", next, SettingCodec.flag());

    assertThat(next.get()).isEqualTo(left);
  }

  @Test
  void whatNobodyBindsStaysInTheFile() throws IOException {
    Files.writeString(file(), "grid-cm=25.0\nscale=2.0\nshow.trail=false\ntrail=false\n");
    Settings settings = load();
    scale.set(1);
    settings.save();

    assertThat(lines()).containsExactly("grid-cm=25.0", "show.trail=false", "trail=false");
  }

  @Test
  void whatIsUnboundStaysInTheFileUnlessItIsTheDefault() throws IOException {
    Files.writeString(file(), "scale=2.0\ntrail=false\n");
    Settings settings = load();
    trail.set(true);
    settings.unbind("scale");
    settings.unbind("trail");
    settings.save();

    assertThat(lines()).containsExactly("scale=2.0");
  }

  @Test
  void whatNoSettingCanBeIsNotKept() throws IOException {
    Files.writeString(file(), "two\\ lines=1\nback=a\\\\b\nnew=a\\nb=c\n=\nempty=\nleft=1.5\n");
    Settings settings = load();
    scale.set(2);
    settings.save();

    assertThat(lines()).containsExactly("left=1.5", "scale=2.0");
  }

  @Test
  void aKeyIsBoundOnce() {
    Settings settings = load();

    assertThatThrownBy(() -> settings.bind("trail", trail, SettingCodec.flag()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("key is trail, but that is bound already");
  }

  private Settings load() {
    return bound(Settings.load(file()));
  }

  private Settings bound(Settings settings) {
    settings.bind("scale", scale, SettingCodec.decimal(0.5, 3));
    settings.bind("trail", trail, SettingCodec.flag());
    settings.bind("theme", theme, SettingCodec.constant(Theme.class));
    return settings;
  }

  private Path file() {
    return directory.resolve("settings.properties");
  }

  private List<String> lines() throws IOException {
    return Files.readAllLines(file()).stream().filter(line -> !line.startsWith("#")).toList();
  }

  private List<String> files() throws IOException {
    try (Stream<Path> all = Files.list(directory)) {
      return all.map(path -> path.getFileName().toString()).toList();
    }
  }
}
