package tellosimulator.view.gallery;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.OverrunStyle;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The files that were open last, as buttons in a row. Which of them are gone is looked for by a
 * thread of its own, as a drive may be far away. For the JavaFX thread.
 */
final class RecentList extends HBox {

  private static final ErrorPolicy FAILED =
      ErrorPolicy.finish("The recent files could not be looked for");

  private static final PseudoClass MISSING = PseudoClass.getPseudoClass("missing");

  private final Messages messages;
  private final List<Path> files;
  private final List<Button> buttons = new ArrayList<>();

  /**
   * @param files of which each has a button
   * @param opener opens a file
   */
  RecentList(Language language, List<Path> files, Consumer<Path> opener) {
    this.messages = language.messages(RecentList.class);
    this.files = List.copyOf(files);
    setId("recent-files");
    getStyleClass().add("recent-files");
    for (Path file : files) {
      buttons.add(button(file, opener));
    }
    getChildren().addAll(buttons);
    Worker.once("recent-files", FAILED, this::lookForThem);
  }

  private Button button(Path file, Consumer<Path> opener) {
    Button button = new Button(String.valueOf(file.getFileName()), new FontIcon(Feather.FILE));
    button.setId("recent-" + (buttons.size() + 1));
    button.setTextOverrun(OverrunStyle.CENTER_ELLIPSIS);
    button.setAlignment(Pos.CENTER_LEFT);
    button.setMaxWidth(Double.MAX_VALUE);
    button.setPrefWidth(0); // all of them have the same
    HBox.setHgrow(button, Priority.ALWAYS);
    Tooltips.install(button, messages.text("file", file));
    button.accessibleTextProperty().bind(messages.text("file", file));
    button.setOnAction(pressed -> opener.accept(file));
    return button;
  }

  /** On a thread of its own. */
  private void lookForThem() {
    Set<Path> gone = new HashSet<>(files);
    gone.removeIf(Files::exists);
    Platform.runLater(() -> mark(gone));
  }

  private void mark(Set<Path> gone) {
    for (int i = 0; i < buttons.size(); i++) {
      Path file = files.get(i);
      if (gone.contains(file)) {
        Button button = buttons.get(i);
        button.pseudoClassStateChanged(MISSING, true);
        button.setGraphic(new FontIcon(Feather.ALERT_CIRCLE));
        button.textProperty().bind(messages.text("missing", file.getFileName()));
        button.accessibleTextProperty().bind(messages.text("missing", file));
      }
    }
  }
}
