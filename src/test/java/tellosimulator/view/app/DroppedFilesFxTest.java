package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.stream.Stream;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.scene.Node;
import javafx.scene.input.DragEvent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.recording.RecordingFixture;

/** Files dragged onto the window, as from a file manager. */
class DroppedFilesFxTest {

  @RegisterExtension private final AppFixture window = new AppFixture(Stage::new);
  @TempDir private Path folder;

  @Test
  void aScenarioIsOpened() throws IOException {
    assertThat(drop(scenario("first.yaml"))).isTrue();

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
    assertThat(drop(scenario("first.yaml"), scenario("second.yaml"))).isFalse();

    assertThat(window.stage().getTitle()).isEqualTo(before);
  }

  private Path scenario(String name) throws IOException {
    return Files.writeString(folder.resolve(name), "room: {width: 400}\n");
  }

  /** Drags files over the scene and drops them if they are accepted. */
  private boolean drop(Path... files) {
    Dragboard dragboard = mock(Dragboard.class);
    when(dragboard.getTransferModes()).thenReturn(EnumSet.of(TransferMode.COPY));
    when(dragboard.getFiles()).thenReturn(Stream.of(files).map(Path::toFile).toList());
    Node scene = onFxThread(() -> window.stage().getScene().lookup("#scene-3d"));
    return onFxThread(
        () -> {
          boolean taken =
              fire(scene, DragEvent.DRAG_OVER, dragboard).getAcceptedTransferMode() != null;
          if (taken) {
            assertThat(fire(scene, DragEvent.DRAG_DROPPED, dragboard).isDropCompleted()).isTrue();
          }
          return taken;
        });
  }

  /** Fires a drag event at a node, as the toolkit does. */
  private static DragEvent fire(Node over, EventType<DragEvent> type, Dragboard dragboard) {
    DragEvent event =
        new DragEvent(type, dragboard, 0, 0, 0, 0, TransferMode.COPY, null, over, null);
    Event.fireEvent(over, event);
    return event;
  }

  private static int windows() {
    return onFxThread(
        () -> (int) Window.getWindows().stream().filter(Stage.class::isInstance).count());
  }
}
