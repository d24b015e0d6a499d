package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.util.Map;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextArea;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.view.ViewContext;
import tellosimulator.view.text.Messages;

/** Which program this is, and the licences of all that is in it. For the JavaFX thread. */
public final class AboutPage extends VBox {

  private final Messages messages;
  private final Map<String, String> texts = LicenceTexts.all();
  private final Label title = new Label();
  private final Label purpose = new Label();
  private final Label versions = new Label();
  private final Label licences = new Label();
  private final ListView<String> documents = new ListView<>();
  private final TextArea text = new TextArea();
  private final Button close = new Button();

  AboutPage(ViewContext context) {
    messages = context.language().messages(AboutPage.class);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  Button closeButton() {
    return close;
  }

  private void initializeSelf() {
    setId("about-page");
    getStyleClass().addAll("page", "about-page");
    getStylesheets().add(AboutPage.class.getResource("pages.css").toExternalForm());
  }

  private void initializeParts() {
    title.setId("about-title");
    title.getStyleClass().add(Styles.TITLE_3);
    versions.setId("about-versions");
    versions.getStyleClass().add("muted");
    purpose.setWrapText(true);
    licences.getStyleClass().addAll(Styles.TEXT_BOLD, "heading");
    documents.setId("about-documents");
    documents.getItems().setAll(texts.keySet());
    documents.setCellFactory(list -> new DocumentCell());
    text.setId("about-text");
    text.setEditable(false);
    text.getStyleClass().add("document");
    close.setId("about-close");
    close.setDefaultButton(true);
  }

  private void layoutParts() {
    HBox library = new HBox(documents, text);
    library.getStyleClass().add("library");
    HBox.setHgrow(text, Priority.ALWAYS);
    VBox.setVgrow(library, Priority.ALWAYS);
    HBox buttons = new HBox(close);
    buttons.getStyleClass().add("page-buttons");
    getChildren().addAll(title, purpose, versions, licences, library, buttons);
  }

  private void setupEventHandlers() {
    documents
        .getSelectionModel()
        .selectedItemProperty()
        .addListener((observed, before, chosen) -> read(chosen));
    documents.getSelectionModel().selectFirst();
  }

  private void setupBindings() {
    title.textProperty().bind(messages.text("program", version()));
    purpose.textProperty().bind(messages.text("purpose"));
    licences.textProperty().bind(messages.text("licences"));
    close.textProperty().bind(messages.text("close"));
    versions
        .textProperty()
        .bind(
            messages.text(
                "versions",
                System.getProperty("java.version"),
                System.getProperty("javafx.runtime.version", "?"),
                System.getProperty("os.name")));
  }

  private void read(String document) {
    text.setText(document == null ? "" : texts.get(document));
    text.positionCaret(0);
    text.setScrollTop(0);
  }

  /** From the jar's manifest. */
  private static String version() {
    return Optional.ofNullable(AboutPage.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  /** A document by its file's name. */
  private final class DocumentCell extends ListCell<String> {
    @Override
    protected void updateItem(String path, boolean empty) {
      super.updateItem(path, empty);
      textProperty().unbind();
      if (empty || path == null) {
        setText("");
      } else if (path.equals(LicenceTexts.NOTICE)) {
        textProperty().bind(messages.text("notice"));
      } else {
        String name = path.substring(path.lastIndexOf('/') + 1);
        setText(name.equals("LICENSE") ? "Apache-2.0" : name.replaceFirst("\\.(txt|md)$", ""));
      }
    }
  }
}
