package tellosimulator.view.fx;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.Node;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;

/** Accepts files or folders by drag and drop. Confined to the JavaFX thread. */
public final class FileDrop {

  private FileDrop() {}

  /**
   * Installs handlers on a node, so that a file or folder can be dropped on it.
   *
   * @param target the node that accepts drops, including those on its descendants
   * @param taker receives the dropped file or folder; a drop of several files is ignored
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
