package tellosimulator.view.app;

import java.util.Objects;
import javafx.scene.image.Image;
import javafx.stage.Stage;

/** The program's icon, which task bars and window managers show. Drawn: packaging/icon.svg. */
final class AppIcon {

  private static final String FILE = "icon.png";

  private AppIcon() {}

  /** Gives it to a window. */
  static void show(Stage stage) {
    String address = Objects.requireNonNull(AppIcon.class.getResource(FILE)).toExternalForm();
    stage.getIcons().add(new Image(address));
  }
}
