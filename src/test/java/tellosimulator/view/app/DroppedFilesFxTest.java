package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.recording.RecordingFixture;

/** Files that a hand drags onto the window, as from a file manager. */
class DroppedFilesFxTest {

  @RegisterExtension private final AppFixture window = new AppFixture(Stage::new);
  @TempDir private Path folder;

  private Path[] dragged = {};
  private volatile boolean over;

  @BeforeEach
  void show() {
    change(() -> ((StackPane) window.stage().getScene().getRoot()).getChildren().add(icon()));
  }

  /** What is dragged, over a corner of the window. */
  private Label icon() {
    Label icon = new Label("files");
    icon.setId("dragged-files");
    icon.setStyle("-fx-background-color: orange; -fx-padding: 12px");
    StackPane.setAlignment(icon, Pos.BOTTOM_LEFT);
    icon.setOnDragDetected(
        drag -> {
          ClipboardContent content = new ClipboardContent();
          content.putFiles(Arrays.stream(dragged).map(Path::toFile).toList());
          icon.startDragAndDrop(TransferMode.COPY).setContent(content);
          drag.consume();
        });
    icon.setOnDragDone(done -> over = true);
    return icon;
  }

  @Test
  void aScenarioIsOpened() throws IOException {
    drop(scenario("first.yaml"));

    waitUntil(() -> window.stage().getTitle().equals("first.yaml – Tello Simulator"));
  }

  @Test
  void aScenarioWithAMistakeIsToldAndTheSceneStays() throws IOException {
    String before = window.stage().getTitle();
    drop(Files.writeString(folder.resolve("wrong.yaml"), "room: {width: wide}\n"));

    waitUntil(() -> window.log().contains("wrong.yaml:1:"));
    assertThat(window.stage().getTitle()).isEqualTo(before);
  }

  @Test
  void aRecordingIsPlayedInAWindowOfItsOwn() throws IOException {
    int windows = windows();
    drop(RecordingFixture.in(folder.resolve("flight")));

    waitUntil(() -> windows() == windows + 1);
    assertThat(window.robot().lookup("#replay-bar").tryQuery()).isPresent();
    assertThat(window.stage().isShowing()).isTrue();
  }

  @Test
  void severalFilesAreNotTaken() throws IOException {
    String before = window.stage().getTitle();
    drop(scenario("first.yaml"), scenario("second.yaml"));
    waitUntil(() -> over);

    assertThat(window.stage().getTitle()).isEqualTo(before);
  }

  private Path scenario(String name) throws IOException {
    return Files.writeString(folder.resolve(name), "room: {width: 400}\n");
  }

  private void drop(Path... files) {
    dragged = files;
    window.robot().drag("#dragged-files").dropTo("#scene-3d");
  }

  private static int windows() {
    return onFxThread(() -> (int) Window.getWindows().stream().filter(Window::isShowing).count());
  }
}
