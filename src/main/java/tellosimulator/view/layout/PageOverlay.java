package tellosimulator.view.layout;

import atlantafx.base.controls.ModalPane;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The layer for pages over the window: help, about, the gallery, questions, errors in a scenario,
 * and the command palette. It covers everything else in the window's root, and is invisible while
 * no page is open. A page is closed by Esc, a click beside it, or its button. Confined to the
 * JavaFX thread.
 */
public final class PageOverlay extends StackPane {

  private final ModalPane pane = Nodes.named(new ModalPane(), "page-overlay-pane");
  private final ViewContext context;
  private Optional<Node> focusedBefore = Optional.empty();

  public PageOverlay(ViewContext context) {
    this.context = context;
    setId("page-overlay");
    setPickOnBounds(false);
    pane.setInTransitionFactory(null);
    pane.setOutTransitionFactory(null);
    pane.displayProperty()
        .addListener(
            (observed, before, shown) -> {
              if (!shown) {
                focusedBefore.ifPresent(Node::requestFocus);
              }
            });
    visibleProperty().bind(pane.displayProperty());
    getChildren().add(pane);
    context.ticker().onTick(nanos -> refreshHelp());
  }

  /** Opens the help, or closes it if it is open. */
  public void toggleHelp() {
    if (shows(HelpPage.class)) {
      pane.hide(true);
    } else {
      HelpPage help = new HelpPage(context); // created lazily, so that the window opens quickly
      help.refresh();
      show(help);
    }
  }

  /**
   * Opens the command palette, or closes it if it is open. Has no effect while a question is
   * waiting for an answer.
   */
  public void togglePalette(WindowCommands commands) {
    if (shows(CommandPalette.class)) {
      pane.hide(true);
    } else if (!asks()) {
      CommandPalette palette =
          new CommandPalette(context.language(), commands, () -> pane.hide(true));
      open(palette, palette::field);
    }
  }

  void showAbout() {
    show(new AboutPage(context));
  }

  /**
   * Opens the gallery, or closes it if it is open.
   *
   * @param chooseFile opens a file chooser, and then the chosen file
   */
  public void toggleGallery(GalleryPane.Offer offer, Runnable chooseFile) {
    if (shows(GalleryPage.class)) {
      pane.hide(true);
    } else {
      open(new GalleryPage(context, offer, chooseFile, this::close));
    }
  }

  private void close(Runnable then) {
    pane.hide(true);
    then.run();
  }

  /** Shows the errors in a scenario. */
  public void show(List<Function<Language, String>> diagnostics) {
    show(new DiagnosticsPage(context, diagnostics));
  }

  /** Asks a question. */
  public void ask(QuestionPage.Question question) {
    open(new QuestionPage(context, question, () -> pane.hide(true)));
  }

  /** Returns whether a question is waiting for an answer. */
  public boolean asks() {
    return shows(QuestionPage.class);
  }

  private boolean shows(Class<? extends Node> page) {
    return pane.isDisplay() && page.isInstance(pane.getContent());
  }

  private void show(Page page) {
    page.defaultButton().setOnAction(pressed -> pane.hide(true));
    open(page);
  }

  private void open(Page page) {
    open(page, page::firstFocus);
  }

  private void open(Node page, Supplier<Node> focused) {
    if (!pane.isDisplay()) {
      focusedBefore = Optional.ofNullable(getScene().getFocusOwner());
    }
    pane.show(page);
    page.applyCss(); // otherwise the content of a scroll pane is not in the scene yet
    focused.get().requestFocus();
  }

  /** Updates the drone's address in the help. The address changes when the drone is switched on. */
  private void refreshHelp() {
    if (pane.isDisplay() && pane.getContent() instanceof HelpPage help) {
      help.refresh();
    }
  }

  /**
   * The page with the errors in a scenario file, each with its line and column. Confined to the
   * JavaFX thread.
   */
  private static final class DiagnosticsPage extends Page {

    /**
     * The maximum number of errors that are shown; the log contains all of them. Decided: more than
     * a user reads at once.
     */
    private static final int MOST = 200;

    DiagnosticsPage(ViewContext context, List<Function<Language, String>> diagnostics) {
      super(
          "mistakes-page",
          context
              .language()
              .messages(DiagnosticsPage.class)
              .text(diagnostics.size() == 1 ? "mistakes-one" : "mistakes", diagnostics.size()));
      Language language = context.language();
      Messages messages = language.messages(DiagnosticsPage.class);
      setMaxHeight(USE_PREF_SIZE);
      VBox lines = Nodes.styled(new VBox(), "lines");
      for (Function<Language, String> diagnostic :
          diagnostics.subList(0, Math.min(MOST, diagnostics.size()))) {
        ObservableValue<String> line =
            language.localeProperty().map(locale -> diagnostic.apply(language));
        lines.getChildren().add(Nodes.wrapping(Nodes.label(line)));
      }
      ScrollPane scroll = new ScrollPane(lines);
      scroll.setFitToWidth(true);
      scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
      addButton("mistakes-close", messages.text("close"));
      layoutPage(messages.label("mistakes-stays", "muted"), scroll);
    }
  }

  /** The page from which the user chooses a scenario. Confined to the JavaFX thread. */
  private static final class GalleryPage extends Page {

    private final GalleryPane gallery;

    /**
     * @param chooseFile opens a file chooser, and then the chosen file
     * @param close closes the page and then runs an action
     */
    GalleryPage(
        ViewContext context,
        GalleryPane.Offer offer,
        Runnable chooseFile,
        Consumer<Runnable> close) {
      super("gallery-page", context.language().messages(GalleryPage.class).text("gallery"));
      Messages messages = context.language().messages(GalleryPage.class);
      ScenarioActions actions = context.scenario().actions();
      gallery =
          new GalleryPane(
              context.language(),
              offer,
              new GalleryPane.OptionValue(
                  name -> close.accept(() -> actions.openKnown(name)),
                  file -> close.accept(() -> actions.open(file))));
      setMaxHeight(USE_PREF_SIZE);
      Button open = addButton("gallery-open", messages.text("gallery-open"));
      open.setDefaultButton(false); // the cards are the primary choice
      open.setOnAction(pressed -> close.accept(chooseFile));
      addButton("gallery-empty", messages.text("gallery-empty"))
          .setOnAction(pressed -> close.accept(actions::openEmpty));
      addButton("gallery-close", messages.text("close"))
          .setOnAction(pressed -> close.accept(() -> {}));
      layoutPage(messages.label("gallery-hint", "muted"), gallery);
    }

    @Override
    Node firstFocus() {
      return gallery.firstCard();
    }
  }
}
