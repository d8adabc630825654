# Filter for Doxygen: prints a source file with the signs in its comments escaped that Doxygen would
# interpret, since our comments are plain text, and without includes of generated files.
while (<>) {
  s/^\s*#\s*include\s.*\.inc>.*//;
  if (m{^(.*?///<?)(.*)$}s) {
    my ($before, $comment) = ($1, $2);
    $comment =~ s/([\\@<>#&%]|::)/\\$1/g;
    $_ = $before . $comment;
  }
  print;
}
