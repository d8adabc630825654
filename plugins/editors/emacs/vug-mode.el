;;; vug-mode.el --- Major mode for Vug scenes  -*- lexical-binding: t; -*-
;; SPDX-License-Identifier: Apache-2.0

;;; Commentary:
;; Highlighting, comments, and the language server `vug lsp` with Eglot.

;;; Code:

(require 'vug-words)

(defvar vug-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?# "<" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?_ "w" table)
    table)
  "Comments of scenes begin with #.")

(defconst vug-font-lock-keywords
  `((,(concat "^\\s-*" (regexp-opt vug-statements 'words) "\\s-+\\(\\w+\\)")
     (1 font-lock-keyword-face) (2 font-lock-variable-name-face))
    (,(concat "^\\s-*" (regexp-opt vug-statements 'words)) . font-lock-keyword-face)
    ("\\<\\([[:alpha:]_]\\w*\\):" 1 font-lock-type-face)
    (,(concat (regexp-opt vug-calls 'words) "(") 1 font-lock-builtin-face)
    ("\\<\\([[:alpha:]_]\\w*\\)(" 1 font-lock-function-name-face)
    (,(regexp-opt vug-words 'words) . font-lock-keyword-face)
    (,(regexp-opt vug-constants 'words) . font-lock-constant-face))
  "Highlighting of scenes.")

;;;###autoload
(define-derived-mode vug-mode prog-mode "Vug"
  "Major mode for Vug scenes."
  (setq-local comment-start "# ")
  (setq-local comment-start-skip "#+\\s-*")
  (setq-local indent-tabs-mode nil)
  (setq-local font-lock-defaults '(vug-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.vug\\'" . vug-mode))

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(vug-mode . ("vug" "lsp"))))

(provide 'vug-mode)
;;; vug-mode.el ends here
