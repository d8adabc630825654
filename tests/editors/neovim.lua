-- SPDX-License-Identifier: Apache-2.0
-- Opens a scene in Neovim with the configuration of plugins/editors, sends requests, renames a name
-- of an included file, and writes the results to $VUG_RESULTS.
local result = {}
local ok, failure = pcall(function()
  require('vug').setup({ program = vim.env.VUG })
  vim.cmd('filetype plugin on')
  vim.cmd('edit main.vug')
  local buffer = vim.api.nvim_get_current_buf()
  result.filetype = vim.bo.filetype
  local ready = vim.wait(60000, function()
    for _, client in pairs(vim.lsp.buf_get_clients(buffer)) do
      if client.initialized then return true end
    end
    return false
  end, 20)
  assert(ready, 'the server does not start')
  local function ask(method, line, character, more)
    local params = vim.tbl_extend('error', {
      textDocument = vim.lsp.util.make_text_document_params(buffer),
      position = { line = line, character = character },
    }, more or {})
    local answers = assert(vim.lsp.buf_request_sync(buffer, method, params, 60000))
    local _, answer = next(answers)
    assert(answer and not answer.error, vim.inspect(answer))
    return answer.result
  end
  result.hover = ask('textDocument/hover', 1, 23).contents.value
  result.definition = ask('textDocument/definition', 1, 23).uri
  result.completion = #ask('textDocument/completion', 1, 21).items
  assert(vim.wait(60000, function() return #vim.diagnostic.get(buffer) > 0 end, 20), 'no diagnostics')
  result.diagnostics = vim.tbl_map(function(each) return each.message end, vim.diagnostic.get(buffer))
  vim.lsp.util.apply_workspace_edit(ask('textDocument/rename', 1, 23, { newName = 'globe' }), 'utf-16')
  vim.cmd('silent wall')
  vim.lsp.buf.formatting_sync({}, 60000)
  vim.cmd('silent write')
end)
if not ok then result.failure = tostring(failure) end
local file = assert(io.open(vim.env.VUG_RESULTS, 'w'))
file:write(vim.fn.json_encode(result))
file:close()
vim.cmd('qall!')
