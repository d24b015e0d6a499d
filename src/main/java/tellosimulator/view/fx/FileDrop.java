package tellosimulator.view.fx;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.Node;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;

/** Lets somebody drop a file or a folder. For the JavaFX thread. */
public final class FileDrop {

  private FileDrop() {}

  /**
   * From now on.
   *
   * @param target on which it can be dropped, or on what is in it
   * @param taker gets what was dropped; several files at once are none
   */
  public static void install(Node target, Consumer<Path> taker) {
    target.setOnDragOver(
        event -> {
          if (dropped(event).isPresent()) {
            event.acceptTransferModes(TransferMode.COPY);
          }
          event.consume();
        });
    target.setOnDragDropped(
        event -> {
          Optional<File> place = dropped(event);
          place.map(File::toPath).ifPresent(taker);
          event.setDropCompleted(place.isPresent());
          event.consume();
        });
  }

  private static Optional<File> dropped(DragEvent event) {
    return Optional.ofNullable(event.getDragboard().getFiles())
        .filter(files -> files.size() == 1)
        .map(files -> files.get(0));
  }
}
